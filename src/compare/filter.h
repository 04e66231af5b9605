// Separable filters over small rectangles of an image: what SSIM and FLIP are made of.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace vkpt {

/// A rectangle of values.
template <class T>
class Grid {
public:
    Grid(std::size_t width, std::size_t height) : width_(width), height_(height), values_(width * height) {}
    [[nodiscard]] std::size_t width() const { return width_; }
    [[nodiscard]] std::size_t height() const { return height_; }
    [[nodiscard]] T* row(std::size_t y) { return values_.data() + y * width_; }
    [[nodiscard]] const T* row(std::size_t y) const { return values_.data() + y * width_; }

private:
    std::size_t width_, height_;
    std::vector<T> values_;
};

/// sum[i] += the sum over t of kernel[t] rows[t * stride + i], for `count` places: the loop that takes the time, and
/// that compilers turn into vector instructions. Four weights at once spare loads and stores.
template <class T>
void addWeighted(T* __restrict__ sum, const T* __restrict__ rows, std::size_t stride, std::span<const T> kernel,
                 std::size_t count) {
    std::size_t t = 0;
    for (; t + 4 <= kernel.size(); t += 4) {
        const T *r0 = rows + t * stride, *r1 = r0 + stride, *r2 = r1 + stride, *r3 = r2 + stride;
        const T k0 = kernel[t], k1 = kernel[t + 1], k2 = kernel[t + 2], k3 = kernel[t + 3];
        for (std::size_t i = 0; i < count; ++i) sum[i] += k0 * r0[i] + k1 * r1[i] + (k2 * r2[i] + k3 * r3[i]);
    }
    for (; t < kernel.size(); ++t)
        for (std::size_t i = 0; i < count; ++i) sum[i] += kernel[t] * rows[t * stride + i];
}

/// Row by row, the sums over t of kernel[t] in(x + t, y), for all but the first and last `margin` columns. The kernel's
/// middle lies on the pixel; its length is odd and at most 2 margin + 1.
template <class T>
Grid<T> filterRows(const Grid<T>& in, std::span<const T> kernel, std::size_t margin) {
    Grid<T> out(in.width() - 2 * margin, in.height());
    const std::size_t first = margin - kernel.size() / 2;
    for (std::size_t y = 0; y < out.height(); ++y) addWeighted(out.row(y), in.row(y) + first, 1, kernel, out.width());
    return out;
}

/// The same along columns.
template <class T>
Grid<T> filterColumns(const Grid<T>& in, std::span<const T> kernel, std::size_t margin) {
    Grid<T> out(in.width(), in.height() - 2 * margin);
    const std::size_t first = margin - kernel.size() / 2;
    for (std::size_t y = 0; y < out.height(); ++y)
        addWeighted(out.row(y), in.row(y + first), in.width(), kernel, out.width());
    return out;
}

}  // namespace vkpt
