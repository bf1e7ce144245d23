#pragma once
#include "Segmentation/RandomWalker.h"
#include "Testing/RandomBone.h"

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <vector>

namespace hasp::testing
{

inline std::vector<Label> LabelsOf(const std::vector<WalkerSeed>& seeds)
{
  std::vector<Label> labels;
  for (const WalkerSeed& seed : seeds)
    labels.push_back(seed.label);
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  return labels;
}

/// The same probabilities by a sparse Cholesky factorisation in long double: weights over twelve
/// decades cost double all its digits. One of each of LabelsOf(seeds); 0 where no seed is
/// connected.
inline std::vector<std::vector<double>> DirectSolution(
  const VoxelGraph& graph, const std::vector<WalkerSeed>& seeds)
{
  using Real = long double;
  const auto nodes = static_cast<std::size_t>(graph.Nodes());
  std::vector<std::int32_t> seedLabel(nodes, 0);
  for (const WalkerSeed& seed : seeds)
    seedLabel[seed.node] = seed.label;
  const std::vector<GraphLink> links = LinksOf(graph);
  std::vector<char> reached(nodes); // from a seed
  for (const WalkerSeed& seed : seeds)
    reached[seed.node] = 1;
  for (bool more = true; more;)
  {
    more = false;
    for (const GraphLink& link : links)
      if (link.weight > 0.0F && reached[link.a] != reached[link.b])
      {
        reached[link.a] = reached[link.b] = 1;
        more = true;
      }
  }
  std::vector<int> unknown(nodes, -1);
  int count = 0;
  for (std::size_t n = 0; n < nodes; ++n)
    if (seedLabel[n] == 0 && reached[n] != 0)
      unknown[n] = count++;
  const std::vector<Label> labels = LabelsOf(seeds);
  using Columns = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
  Columns right = Columns::Zero(count, static_cast<int>(labels.size()));
  const auto column = [&](std::int32_t label)
  {
    return static_cast<int>(std::lower_bound(labels.begin(), labels.end(), label) - labels.begin());
  };
  std::vector<Eigen::Triplet<Real>> entries;
  const auto half = [&](std::int32_t from, std::int32_t to, Real w)
  {
    const int row = unknown[from];
    if (row < 0)
      return;
    entries.emplace_back(row, row, w);
    if (unknown[to] >= 0)
      entries.emplace_back(row, unknown[to], -w);
    else
      right(row, column(seedLabel[to])) += w;
  };
  for (const GraphLink& link : links)
  {
    half(link.a, link.b, link.weight);
    half(link.b, link.a, link.weight);
  }
  Eigen::SparseMatrix<Real> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<Real>> factor(matrix);
  const Columns x = factor.solve(right);
  std::vector<std::vector<double>> solutions(labels.size(), std::vector<double>(nodes));
  for (std::size_t l = 0; l < labels.size(); ++l)
    for (std::size_t n = 0; n < nodes; ++n)
      solutions[l][n] = unknown[n] >= 0 ? static_cast<double>(x(unknown[n], static_cast<int>(l)))
                                        : (seedLabel[n] == labels[l] ? 1.0 : 0.0);
  return solutions;
}

} // namespace hasp::testing
