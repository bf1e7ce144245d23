#pragma once
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace hasp
{

struct Passport;

/// What is known of a volume, a line a fact. No patient's text is in a passport.
std::string PassportText(const Passport& passport);

/// The same; sizes in millimetres, direction by rows.
nlohmann::ordered_json PassportJson(const Passport& passport);

} // namespace hasp
