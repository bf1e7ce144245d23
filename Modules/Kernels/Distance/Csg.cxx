#include "Distance/Csg.h"

#include "BoxTree.h"
#include "SolidChecks.h"

namespace hasp
{

namespace
{
using Sample = ImplicitSolid::Sample;
using Box = ImplicitSolid::Box;

constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr double FilmMm = 1e-5;      ///< half of what is too thin to be meant
constexpr double FilmProbeMm = 1e-4; ///< well off a film on both sides
constexpr int FilmLevels = 3;        ///< films of three directions meet in a point

/// The value of a node where those of two parts tie next to 0. If both sides of the first one's
/// face lie on the same side of the node's surface, it is no surface but a film.
///
/// sign    1 if matter is the film, which goes; -1 if a gap is, which is filled
/// valueAt the node's at another place
template <typename ValueAt>
double WithoutFilm(double value, double sign, const glm::dvec3& x, const glm::dvec3& gradient,
  const ValueAt& valueAt) noexcept
{
  const glm::dvec3 step = FilmProbeMm * gradient;
  return sign * valueAt(x + step) >= FilmMm && sign * valueAt(x - step) >= FilmMm ? sign * FilmMm
                                                                                  : value;
}

/// The extreme value of several, which part it is of, and the next.
struct Extremes
{
  double first, second;
  std::size_t part = 0;

  bool MayBeFilm() const
  {
    return std::abs(this->first) <= FilmMm && std::abs(this->second - this->first) <= 2.0 * FilmMm;
  }
};

/// Parts one after the other, each with its faces behind those of the parts before.
class Parts : public ImplicitSolid
{
public:
  Parts(const char* node, std::vector<SolidPointer> parts) : All(std::move(parts))
  {
    double faces = 0.0;
    for (const SolidPointer& part : this->All)
    {
      this->First.push_back(CheckedFaceCount(node, faces));
      faces += part->Faces();
      this->Steep = std::max(this->Steep, part->Steepness());
    }
    this->First.push_back(CheckedFaceCount(node, faces));
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    const auto part = std::upper_bound(this->First.begin() + 1, this->First.end() - 1, face) - 1;
    return this->Of(
      part - this->First.begin(), this->All[part - this->First.begin()]->FaceAt(face - *part, x));
  }
  std::uint32_t Faces() const noexcept override { return this->First.back(); }
  double Steepness() const noexcept override { return this->Steep; }
  const std::vector<SolidPointer>& Children() const { return this->All; }

protected:
  static constexpr std::size_t None = ~std::size_t{ 0 };
  /// The sample of the part that was asked first, as it is the one that counts more often than
  /// others: it need not be asked again, and its parts in turn.
  struct Known
  {
    Sample sample;
    std::size_t part = None;
  };
  double ValueOf(std::size_t part, const glm::dvec3& x, Known* known) const noexcept
  {
    if (!known)
      return this->All[part]->At(x);
    *known = { this->All[part]->SampleAt(x), part };
    return known->sample.value;
  }
  Sample Of(std::size_t part, Sample s) const noexcept
  {
    s.face += this->First[part];
    return s;
  }

  std::vector<SolidPointer> All;
  std::vector<std::uint32_t> First; ///< face of each part, and how many there are
  double Steep = 1.0;
};

class Union : public Parts
{
public:
  explicit Union(std::vector<SolidPointer> parts)
    : Parts("union", std::move(parts)),
      Tree(BoxesOf(this->All))
  {
  }
  double At(const glm::dvec3& x) const noexcept override
  {
    return this->Value(this->Least(x), x, FilmLevels);
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    Known first;
    const Extremes least = this->Least(x, &first);
    const double tie = least.first + SolidTieMm;
    std::size_t part = least.part;
    if (least.second <= tie)
      this->Tree.Within(x, tie,
        [&](std::uint32_t n)
        {
          if (n < part && this->All[n]->At(x) <= tie)
            part = n;
        });
    Sample s = this->Of(part, part == first.part ? first.sample : this->All[part]->SampleAt(x));
    s.value = this->Value(least, x, FilmLevels);
    return s;
  }
  Box Bounds() const noexcept override { return this->Tree.Hull(); }

private:
  Extremes Least(const glm::dvec3& x, Known* first = nullptr) const noexcept
  {
    Extremes least{ Infinite, Infinite };
    double bound = Infinite;
    this->Tree.Within(x, bound,
      [&](std::uint32_t n)
      {
        const double value = this->ValueOf(n, x, first && first->part == None ? first : nullptr);
        if (value < least.first)
          least = { value, least.first, n };
        else
          least.second = std::min(least.second, value);
        bound = least.first + 2.0 * FilmMm;
      });
    return least;
  }
  double Value(const Extremes& least, const glm::dvec3& x, int level) const noexcept
  {
    if (level == 0 || !least.MayBeFilm())
      return least.first;
    return WithoutFilm(least.first, -1.0, x, this->All[least.part]->SampleAt(x).gradient,
      [&](const glm::dvec3& y) { return this->Value(this->Least(y), y, level - 1); });
  }
  static std::vector<Box> BoxesOf(const std::vector<SolidPointer>& parts)
  {
    std::vector<Box> boxes;
    for (const SolidPointer& part : parts)
      boxes.push_back(part->Bounds());
    return boxes;
  }

  BoxTree Tree;
};

class Intersection : public Parts
{
public:
  explicit Intersection(std::vector<SolidPointer> parts) : Parts("intersection", std::move(parts))
  {
  }
  double At(const glm::dvec3& x) const noexcept override
  {
    return this->Value(this->Most(x), x, FilmLevels);
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    Known first;
    const Extremes most = this->Most(x, &first);
    std::size_t part = most.part;
    if (most.second >= most.first - SolidTieMm)
      for (part = 0; this->All[part]->At(x) < most.first - SolidTieMm;)
        ++part;
    Sample s = this->Of(part, part == first.part ? first.sample : this->All[part]->SampleAt(x));
    s.value = this->Value(most, x, FilmLevels);
    return s;
  }
  Box Bounds() const noexcept override
  {
    Box box;
    for (const SolidPointer& part : this->All)
    {
      const Box b = part->Bounds();
      box = { glm::max(box.low, b.low), glm::min(box.high, b.high) };
    }
    return box;
  }

private:
  Extremes Most(const glm::dvec3& x, Known* first = nullptr) const noexcept
  {
    Extremes most{ -Infinite, -Infinite };
    for (std::size_t n = 0; n < this->All.size(); ++n)
    {
      const double value = this->ValueOf(n, x, n == 0 ? first : nullptr);
      if (value > most.first)
        most = { value, most.first, n };
      else
        most.second = std::max(most.second, value);
    }
    return most;
  }
  double Value(const Extremes& most, const glm::dvec3& x, int level) const noexcept
  {
    if (level == 0 || !most.MayBeFilm())
      return most.first;
    return WithoutFilm(most.first, 1.0, x, this->All[most.part]->SampleAt(x).gradient,
      [&](const glm::dvec3& y) { return this->Value(this->Most(y), y, level - 1); });
  }
};

class Difference : public ImplicitSolid
{
public:
  Difference(SolidPointer body, SolidPointer tool)
    : Body(std::move(body)),
      Tool(std::move(tool)),
      ToolBox(this->Tool->Bounds()),
      BodyFaces(this->Body->Faces()),
      AllFaces(CheckedFaceCount("difference", double(this->BodyFaces) + this->Tool->Faces()))
  {
  }
  double At(const glm::dvec3& x) const noexcept override
  {
    return this->Value(this->Both(x), x, FilmLevels);
  }
  Sample SampleAt(const glm::dvec3& x) const noexcept override
  {
    // Each is asked once: of cuts in cuts along one face it would be twice as often at each level.
    const Sample body = this->Body->SampleAt(x);
    if (this->IsFar(x, body.value))
      return body;
    const Sample tool = this->OfTool(this->Tool->SampleAt(x));
    const Extremes both = Greater(body.value, tool.value);
    Sample s = both.part == 1 && both.second < both.first - SolidTieMm ? tool : body;
    s.value = both.MayBeFilm()
                ? this->OfFilm(both, x, (both.part == 0 ? body : tool).gradient, FilmLevels)
                : both.first;
    return s;
  }
  Sample FaceAt(std::uint32_t face, const glm::dvec3& x) const noexcept override
  {
    return face < this->BodyFaces ? this->Body->FaceAt(face, x)
                                  : this->OfTool(this->Tool->FaceAt(face - this->BodyFaces, x));
  }
  std::uint32_t Faces() const noexcept override { return this->AllFaces; }
  Box Bounds() const noexcept override { return this->Body->Bounds(); }
  double Steepness() const noexcept override
  {
    return std::max(this->Body->Steepness(), this->Tool->Steepness());
  }

private:
  /// The greater of the body and minus the tool, which is at most minus its excess.
  Extremes Both(const glm::dvec3& x) const noexcept
  {
    const double body = this->Body->At(x);
    return this->IsFar(x, body) ? Extremes{ body, -Infinite, 0 }
                                : Greater(body, -this->Tool->At(x));
  }
  bool IsFar(const glm::dvec3& x, double body) const noexcept
  {
    return -this->ToolBox.Excess(x) < body - 3.0 * FilmMm;
  }
  static Extremes Greater(double body, double tool) noexcept
  {
    return tool > body ? Extremes{ tool, body, 1 } : Extremes{ body, tool, 0 };
  }
  double Value(const Extremes& both, const glm::dvec3& x, int level) const noexcept
  {
    if (level == 0 || !both.MayBeFilm())
      return both.first;
    const Sample side = both.part == 0 ? this->Body->SampleAt(x) : this->Tool->SampleAt(x);
    return this->OfFilm(both, x, side.gradient, level);
  }
  double OfFilm(
    const Extremes& both, const glm::dvec3& x, const glm::dvec3& gradient, int level) const noexcept
  {
    return WithoutFilm(both.first, 1.0, x, gradient,
      [&](const glm::dvec3& y) { return this->Value(this->Both(y), y, level - 1); });
  }
  Sample OfTool(const Sample& s) const noexcept
  {
    return { -s.value, -s.gradient, s.face + this->BodyFaces };
  }

  SolidPointer Body, Tool;
  Box ToolBox;
  std::uint32_t BodyFaces, AllFaces;
};

void RequireParts(const char* node, const std::vector<SolidPointer>& parts)
{
  if (parts.empty())
    throw std::invalid_argument(std::string(node) + ": there are no parts; give one at least");
  for (const SolidPointer& part : parts)
    RequirePart(node, part);
}
} // namespace

namespace
{
/// One node of all parts, in place of nodes in each other: where many of these tie, each would ask
/// its parts anew for films, and they theirs.
template <typename Node>
SolidPointer Join(const char* name, const std::vector<SolidPointer>& parts)
{
  RequireParts(name, parts);
  if (parts.size() == 1)
    return parts.front();
  std::vector<SolidPointer> all;
  for (const SolidPointer& part : parts)
    if (const auto* inner = dynamic_cast<const Node*>(part.get()))
      all.insert(all.end(), inner->Children().begin(), inner->Children().end());
    else
      all.push_back(part);
  return std::make_shared<Node>(std::move(all));
}
} // namespace

SolidPointer MakeUnion(std::vector<SolidPointer> parts)
{
  return Join<Union>("union", parts);
}

SolidPointer MakeIntersection(std::vector<SolidPointer> parts)
{
  return Join<Intersection>("intersection", parts);
}

SolidPointer MakeDifference(SolidPointer body, SolidPointer tool)
{
  RequirePart("difference", body);
  RequirePart("difference", tool);
  return std::make_shared<Difference>(std::move(body), std::move(tool));
}

} // namespace hasp
