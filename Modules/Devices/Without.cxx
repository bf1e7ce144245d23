#include "Devices/RigidFit.h"
#include "Devices/TrackerCalibration.h"

#include <stdexcept>
#include <string>

// What this build was made without: it is named, so that the error says what to do.
namespace hasp
{

#if !HASP_WITH_EIGEN
RigidFit FitRigid(std::span<const PointPair>, const RigidFitWords& words)
{
  throw std::runtime_error(std::string(words.what) +
                           ": this build of Hasp was made without fits; configure"
                           " it with HASP_ENABLE_EIGEN=ON (Debian: libeigen3-dev)");
}
#endif

#if !HASP_WITH_JSON
TrackerCalibration ParseTrackerCalibration(const std::string&)
{
  throw std::runtime_error("tracker calibration: this build of Hasp was made without its files;"
                           " configure it with HASP_ENABLE_JSON=ON (Debian: nlohmann-json3-dev)");
}

std::string FormatTrackerCalibration(const TrackerCalibration&)
{
  throw std::runtime_error("tracker calibration: this build of Hasp was made without its files;"
                           " configure it with HASP_ENABLE_JSON=ON (Debian: nlohmann-json3-dev)");
}
#endif

} // namespace hasp
