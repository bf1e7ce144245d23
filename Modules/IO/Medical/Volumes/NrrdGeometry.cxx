#include "Files/Words.h"
#include "Volumes/IndexSteps.h"
#include "Volumes/NrrdHeader.h"

#include <cmath>

namespace hasp
{
namespace
{

std::vector<std::string> WordsOf(std::string_view text)
{
  std::vector<std::string> all;
  Words words(text);
  for (std::string_view word = words.Next(); !word.empty(); word = words.Next())
    all.emplace_back(word);
  return all;
}

/// "(1,0,0) none (0,1,0)" as one entry an axis. Blanks may stand anywhere.
std::vector<std::optional<glm::dvec3>> Vectors(
  const std::filesystem::path& file, const std::string& text, const char* name)
{
  std::vector<std::optional<glm::dvec3>> vectors;
  for (std::size_t at = 0; (at = text.find_first_not_of(" \t", at)) != text.npos;)
  {
    if (LowerCase(text.substr(at, 4)) == "none")
    {
      vectors.emplace_back();
      at += 4;
      continue;
    }
    const std::size_t end = text.find(')', at);
    std::string inside =
      text[at] == '(' && end != text.npos ? text.substr(at + 1, end - at - 1) : "";
    for (char& c : inside)
      c = c == ',' ? ' ' : c;
    const auto numbers = FiniteNumbers(inside, 3);
    if (!numbers)
      ThrowFileError(file, std::string(name) + " must be vectors of 3 finite numbers, as (1,0,0)");
    vectors.emplace_back(glm::dvec3((*numbers)[0], (*numbers)[1], (*numbers)[2]));
    at = end + 1;
  }
  return vectors;
}

/// Signs that turn the file's axes into L, P and S.
glm::dvec3 SpaceSigns(
  const std::filesystem::path& file, const std::string& space, Passport& passport)
{
  const std::string name = LowerCase(space);
  if (name == "left-posterior-superior" || name == "lps")
    return { 1, 1, 1 };
  if (name == "right-anterior-superior" || name == "ras")
    return { -1, -1, 1 };
  if (name == "left-anterior-superior" || name == "las")
    return { 1, -1, 1 };
  if (name == "3d-left-handed")
    ThrowFileError(file, "space is left-handed and does not say how it lies in the patient: left "
                         "and right would be a guess. Save it with space left-posterior-superior");
  if (!name.empty() && name != "3d-right-handed" && name != "scanner-xyz")
    ThrowFileError(file, "space is none that is read: left-posterior-superior, "
                         "right-anterior-superior or left-anterior-superior");
  passport.warnings.push_back(
    "The file does not say how its space lies in the patient; it is taken "
    "as left-posterior-superior. Check left and right.");
  return { 1, 1, 1 };
}

/// Steps along the axes where only their lengths are known.
glm::dmat3 StepsOfSpacings(const std::filesystem::path& file, const NrrdHeader& header)
{
  const auto words = WordsOf(header.Field("spacings"));
  std::string spacings;
  for (const std::string& word : words)
    if (words.size() == 3 || LowerCase(word) != "nan") // the fourth axis has none
      spacings += word + " ";
  const auto numbers = FiniteNumbers(spacings, 3);
  if (!numbers)
    ThrowFileError(file, "lacks space directions or three spacings; a spacing is never guessed");
  glm::dmat3 steps(1.0);
  for (int a = 0; a < 3; ++a)
  {
    steps[a][a] = (*numbers)[a];
    if (!(steps[a][a] > 0.0)) // two of them would else be a half turn
      ThrowFileError(file, "spacings must be > 0");
  }
  return steps;
}

} // namespace

std::vector<NrrdAxis> NrrdAxes(const std::filesystem::path& file, const NrrdHeader& header)
{
  const std::int64_t dimension = header.WholeNumber(file, "dimension", 1);
  if (dimension != 3 && dimension != 4)
    ThrowFileError(
      file, "dimension is " + std::to_string(dimension) + ", must be 3, or 4 with one component");
  std::vector<NrrdAxis> axes(static_cast<std::size_t>(dimension));
  const auto sizes = FiniteNumbers(header.Field("sizes"), axes.size());
  if (!sizes)
    ThrowFileError(file, "sizes must be one whole number for each dimension");
  for (std::size_t a = 0; a < axes.size(); ++a)
  {
    const double size = (*sizes)[a];
    if (size != std::floor(size) || size < 1.0 || size > 1e15)
      ThrowFileError(file, "sizes hold " + Text(size) + ", must be whole numbers >= 1");
    axes[a].size = static_cast<std::int64_t>(size);
  }
  if (const auto kinds = WordsOf(LowerCase(header.Field("kinds"))); kinds.size() == axes.size())
    for (std::size_t a = 0; a < axes.size(); ++a)
      axes[a].kind = kinds[a];
  else if (!kinds.empty())
    ThrowFileError(file, "kinds must be one word for each dimension");
  if (const auto steps = Vectors(file, header.Field("space directions"), "space directions");
      steps.size() == axes.size())
    for (std::size_t a = 0; a < axes.size(); ++a)
      axes[a].step = steps[a];
  else if (!steps.empty())
    ThrowFileError(file, "space directions must be one vector for each dimension");
  return axes;
}

void SetNrrdGeometry(const std::filesystem::path& file, const NrrdHeader& header,
  const std::vector<NrrdAxis>& spatial, Passport& passport)
{
  for (const std::string& unit : WordsOf(header.Field("space units")))
    if (unit != "\"mm\"" && unit != "\"\"")
      ThrowFileError(file, "space units must be mm; save it in millimetres");
  const bool directed = spatial[0].step && spatial[1].step && spatial[2].step;
  glm::dmat3 steps = directed ? glm::dmat3(*spatial[0].step, *spatial[1].step, *spatial[2].step)
                              : StepsOfSpacings(file, header);
  const glm::dvec3 signs = SpaceSigns(file, header.Field("space"), passport);
  const auto origin = Vectors(file, header.Field("space origin"), "space origin");
  if (origin.size() > 1 || (origin.size() == 1 && !origin[0]))
    ThrowFileError(file, "space origin must be one vector");
  if (origin.empty())
    passport.warnings.push_back(
      "The file says no position: the first sample is put at the origin.");
  GridGeometry& g = passport.geometry;
  for (int a = 0; a < 3; ++a)
  {
    g.dims[a] = static_cast<int>(spatial[a].size);
    steps[a] *= signs;
  }
  g.origin = origin.empty() ? glm::dvec3(0.0) : *origin[0] * signs;
  SetIndexSteps(file, steps, g);
}

} // namespace hasp
