#include "OnePiece.h"

#include "Distance/TetrahedraContour.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace hasp
{

TriangleMesh OnePiece(const TriangleMesh& mesh, const std::string& who, const std::string& remedy)
{
  constexpr double crumbShare = 0.01;
  const std::vector<double> volumes = FindPieces(mesh).volume;
  const double largest = volumes.empty() ? 0.0 : *std::max_element(volumes.begin(), volumes.end());
  if (!(largest > 0.0))
    throw std::runtime_error(who + ": nothing is left; " + remedy);
  std::ostringstream list;
  int pieces = 0, hollows = 0;
  for (const double v : volumes)
    if (std::abs(v) >= crumbShare * largest)
    {
      (v > 0.0 ? pieces : hollows) += 1;
      list << (list.tellp() > 0 ? ", " : "") << v;
    }
  if (pieces == 1 && hollows == 0)
    return WithoutSmallPieces(mesh, crumbShare * largest);
  throw std::runtime_error(who + ": it falls into " + std::to_string(pieces) + " pieces and " +
                           std::to_string(hollows) + " hollows (mm3: " + list.str() + "); " +
                           remedy);
}

} // namespace hasp
