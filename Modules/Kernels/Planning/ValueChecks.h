#pragma once
#include <glm/vec3.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace hasp
{

/// What plans and recipes ask of their numbers. Each throws std::invalid_argument as "SUBJECT: KEY
/// is VALUE, must be …"; KEY is one of ours, as it stands in the file. Internal. Any thread.
class ValueChecks
{
public:
  /// `subject` is what is checked, such as "guide recipe" or "plan: cuts[2]".
  explicit ValueChecks(std::string subject) : Subject(std::move(subject)) {}

  /// In [low, high], or in (low, high]; a NaN is in neither.
  void Closed(const std::string& key, double value, double low, double high) const;
  void AboveUpTo(const std::string& key, double value, double low, double high) const;
  /// Each coordinate in [-4000, 4000] mm: an STL's float32 still tells 0.0003 mm apart there.
  void Point(const std::string& key, const glm::dvec3& point) const;
  /// Each of a list; its key is made for the one that is refused alone.
  void Points(const char* list, const std::vector<glm::dvec3>& points) const;
  /// Length 1 within 1e-3.
  void Unit(const std::string& key, const glm::dvec3& direction) const;
  /// UTF-8, at most 200 bytes, no control characters. The message does not quote the text.
  void Text(const std::string& key, const std::string& text) const;
  /// 64 hexadecimal digits in lower case.
  void Hash(const std::string& key, const std::string& hash) const;

  /// "SUBJECT: KEY is VALUE, must be MUST", and "SUBJECT: KEY MUST".
  [[noreturn]] void Refuse(const std::string& key, double value, const std::string& must) const;
  [[noreturn]] void Refuse(const std::string& key, const std::string& must) const;

private:
  std::string Subject;
};

/// "list[n]", "list[n].key"
std::string ListKey(const char* list, std::size_t n);
std::string ListKey(const char* list, std::size_t n, const char* key);

} // namespace hasp
