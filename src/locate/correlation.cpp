// SPDX-License-Identifier: GPL-3.0-or-later
#include "correlation.hpp"

#include <fftw3.h>

#include <algorithm>
#include <mutex>

namespace roomatlas {
namespace {

/// The least number from `least` on whose only factors are 2, 3 and 5: others take long.
int of_small_factors(int least) {
  for (int size = std::max(1, least);; ++size) {
    int rest = size;
    for (const int factor : {2, 3, 5}) {
      while (rest % factor == 0) rest /= factor;
    }
    if (rest == 1) return size;
  }
}

/// FFTW makes and destroys plans in one thread at a time; any number of threads may use them.
std::mutex& planner() {
  static std::mutex mutex;
  return mutex;
}

void transform(fftwf_plan_s* plan, std::vector<std::complex<float>>& plane) {
  auto* const values = reinterpret_cast<fftwf_complex*>(plane.data());
  fftwf_execute_dft(plan, values, values);
}

}  // namespace

void CorrelationPlane::Destroy::operator()(fftwf_plan_s* plan) const {
  const std::lock_guard lock(planner());
  fftwf_destroy_plan(plan);
}

/// Estimated and not measured, so that the same plane is always transformed in the same order.
CorrelationPlane::Plan CorrelationPlane::plan(int sign) const {
  Spectrum any(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  auto* const values = reinterpret_cast<fftwf_complex*>(any.data());
  const std::lock_guard lock(planner());
  return Plan(
      fftwf_plan_dft_2d(height_, width_, values, values, sign, FFTW_ESTIMATE | FFTW_UNALIGNED));
}

CorrelationPlane::CorrelationPlane(const Layers& layers, int max_query_cells)
    : building_(layers.on_wall.domain.bounds()),
      width_(of_small_factors(building_.width() + max_query_cells)),
      height_(of_small_factors(building_.height() + max_query_cells)),
      forward_(plan(FFTW_FORWARD)),
      backward_(plan(FFTW_BACKWARD)),
      on_wall_(spectrum_of(layers.on_wall, {}, building_.min)),
      on_floor_(spectrum_of(layers.on_floor, {}, building_.min)) {}

CorrelationPlane::Spectrum CorrelationPlane::spectrum_of(const Raster<float>& real,
                                                         const Raster<float>& imaginary,
                                                         const Cell& origin) const {
  Spectrum plane(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for_each_cell(real.domain, [&](const Cell& cell) {
    plane[static_cast<std::size_t>(cell.y - origin.y) * static_cast<std::size_t>(width_) +
          static_cast<std::size_t>(cell.x - origin.x)] = {real[cell], imaginary.get(cell)};
  });
  transform(forward_.get(), plane);
  return plane;
}

std::size_t CorrelationPlane::mirrored(std::size_t at) const {
  const auto width = static_cast<std::size_t>(width_);
  const auto height = static_cast<std::size_t>(height_);
  const std::size_t x = at % width;
  const std::size_t y = at / width;
  return (height - y) % height * width + (width - x) % width;
}

Raster<float> CorrelationPlane::scores(const Query& query) const {
  const Spectrum both = spectrum_of(query.wall, query.floor, query.wall.domain.bounds().min);
  Spectrum product(both.size());
  // Two real pictures in one complex transform: the even part is the one's, the odd the other's.
  for (std::size_t at = 0; at < both.size(); ++at) {
    const std::complex<float> mirror = std::conj(both[mirrored(at)]);
    const std::complex<float> wall = (both[at] + mirror) * 0.5F;
    const std::complex<float> floor = (both[at] - mirror) * std::complex<float>(0.0F, -0.5F);
    product[at] = std::conj(wall) * on_wall_[at] + std::conj(floor) * on_floor_[at];
  }
  transform(backward_.get(), product);
  const float share = 1.0F / static_cast<float>(product.size());  // FFTW does not divide
  const int margin_x = query.wall.domain.bounds().width() - 1;
  const int margin_y = query.wall.domain.bounds().height() - 1;
  const Cell first{building_.min.x - query.wall.domain.bounds().min.x,
                   building_.min.y - query.wall.domain.bounds().min.y};
  Raster<float> scores(CellBox{{first.x - margin_x, first.y - margin_y},
                               {first.x + building_.width(), first.y + building_.height()}});
  for_each_cell(scores.domain, [&](const Cell& shift) {
    const int x = (shift.x - first.x + width_) % width_;
    const int y = (shift.y - first.y + height_) % height_;
    const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                    static_cast<std::size_t>(x);
    scores[shift] = share * product[at].real();
  });
  return scores;
}

}  // namespace roomatlas
