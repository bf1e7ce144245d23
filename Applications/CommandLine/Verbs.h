#pragma once

namespace CLI
{
class App;
}

/// The verbs of `hasp`, one file each. A function adds its verb to the command line; when the verb
/// is what the user asked for, it sets Session::run.
namespace hasp
{

struct Session;

/// All verbs of this build.
void AddVerbs(CLI::App& app, Session& session);

void AddInfoVerb(CLI::App& app, Session& session);
void AddConvertVerb(CLI::App& app, Session& session);
void AddCompareVerb(CLI::App& app, Session& session);
void AddCellsVerb(CLI::App& app, Session& session);
void AddRenderVerb(CLI::App& app, Session& session);
void AddViewVerb(CLI::App& app, Session& session);
void AddCalibrateVerb(CLI::App& app, Session& session);
void AddDevicesVerb(CLI::App& app, Session& session);
void AddPhantomVerb(CLI::App& app, Session& session);
void AddFractureVerb(CLI::App& app, Session& session);
void AddSegmentVerb(CLI::App& app, Session& session);
void AddCutVerb(CLI::App& app, Session& session);
void AddGuideVerb(CLI::App& app, Session& session);
void AddCertifyVerb(CLI::App& app, Session& session);
void AddPlateVerb(CLI::App& app, Session& session);
void AddImplantVerb(CLI::App& app, Session& session);
void AddMirrorVerb(CLI::App& app, Session& session);
void AddPlanVerb(CLI::App& app, Session& session);
void AddReduceVerb(CLI::App& app, Session& session);
void AddRunVerb(CLI::App& app, Session& session);
void AddEvaluateVerb(CLI::App& app, Session& session);
void AddTransplantVerb(CLI::App& app, Session& session);
void AddReportVerb(CLI::App& app, Session& session);

} // namespace hasp
