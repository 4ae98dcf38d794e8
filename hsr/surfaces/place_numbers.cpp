#include "hsr/surfaces/place_numbers.h"

#include <algorithm>
#include <numeric>

namespace hsr::internal {

std::vector<std::uint32_t> place_numbers(const std::vector<NumberedPlace>& places) {
  // To round keeps the order, so doubles that differ are in the order of what they stand for.
  const auto less = [&](std::uint32_t i, std::uint32_t j) {
    const NumberedPlace &a = places[i], &b = places[j];
    for (std::size_t k = 0; k < 2; ++k) {
      if (a.rounded[k] != b.rounded[k]) return a.rounded[k] < b.rounded[k];
      if ((*a.exact)[k] != (*b.exact)[k]) return (*a.exact)[k] < (*b.exact)[k];
    }
    return false;
  };
  std::vector<std::uint32_t> order(places.size()), numbers(places.size(), 0);
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), less);
  for (std::size_t k = 1; k < order.size(); ++k)
    numbers[order[k]] = numbers[order[k - 1]] + (less(order[k - 1], order[k]) ? 1U : 0U);
  return numbers;
}

}  // namespace hsr::internal
