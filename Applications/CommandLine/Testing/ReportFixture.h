#pragma once
// Reports as their users get them, and a row of one.
#include "HaspProcess.h"

#include <nlohmann/json.hpp>

#include <string>

class HaspReport : public HaspTest
{
};

using Json = nlohmann::json;

inline Json Row(const Json& report, const std::string& id)
{
  for (const Json& row : report.at("rows"))
    if (row.at("id") == id)
      return row;
  ADD_FAILURE() << "no row " << id;
  return {};
}
