#pragma once

namespace hasp
{

struct ReportContext;

/// `hasp report cells`: bytes, extraction, edits, frames, rays and streaming of clustered cells
/// against a mesh, each with its error. RENDER thread.
void ReportCells(ReportContext& context);

} // namespace hasp
