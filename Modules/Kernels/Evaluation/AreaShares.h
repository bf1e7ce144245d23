#pragma once
#include <algorithm>
#include <utility>
#include <vector>

namespace hasp
{

/// Figures weighted by area, for percentiles. One thread.
class AreaShares
{
public:
  void Add(double figure, double area)
  {
    this->Figures.emplace_back(figure, area);
    this->Sum += area;
  }
  /// Before Below, once all are in.
  void Sort() { std::sort(this->Figures.begin(), this->Figures.end()); }
  double Area() const { return this->Sum; }
  bool Empty() const { return this->Figures.empty(); }
  /// The figure below or at which that share of the area lies; 0 if there is none.
  double Below(double share) const
  {
    double sum = 0.0;
    for (const auto& [figure, area] : this->Figures)
      if ((sum += area) >= share * this->Sum)
        return figure;
    return this->Figures.empty() ? 0.0 : this->Figures.back().first;
  }

  double Most() const { return this->Figures.empty() ? 0.0 : this->Figures.back().first; }

private:
  std::vector<std::pair<double, double>> Figures; ///< figure, area
  double Sum = 0.0;
};

} // namespace hasp
