#pragma once
#include <QString>

#include <glm/vec3.hpp>

namespace hasp
{

///@{
/// Three numbers as they are typed: "12.5 -3 0", with commas between them or not; a point before
/// decimals, in all languages, as in the plan's files. Any thread.
/// False, and nothing is read, unless it is three numbers.
bool ReadNumbers(const QString& text, glm::dvec3& numbers);
QString WriteNumbers(const glm::dvec3& numbers, int decimals);
///@}

} // namespace hasp
