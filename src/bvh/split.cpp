#include "bvh/split.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace vkpt {

namespace {

constexpr std::uint32_t kBins = 16;
constexpr std::size_t kSweepItems = 6;    // up to so many, every cut is tried
constexpr std::size_t kChunk = 1U << 15;  // items of one task; fixed, so that results do not depend on threads

/// Maps twice an item's middle to a bin along each axis. An axis without extent maps everything to bin 0.
struct Grid {
    Float4 origin{}, scale{};

    explicit Grid(const Bounds& centroids) : origin(centroids.lo) {
        for (int axis = 0; axis < 3; ++axis) {
            // Slightly less than kBins, so that the upper end falls into the last bin.
            const float perUnit = kBins * 0.9999F / (centroids.hi[axis] - centroids.lo[axis]);
            scale[axis] = perUnit < std::numeric_limits<float>::max() ? perUnit : 0.0F;
        }
    }
    [[nodiscard]] Int4 bins(Float4 centroid) const {
        return __builtin_convertvector((centroid - origin) * scale, Int4);
    }
    [[nodiscard]] std::int32_t bin(Float4 centroid, int axis) const {
        return static_cast<std::int32_t>((centroid[axis] - origin[axis]) * scale[axis]);
    }
};

struct Bins {
    std::array<std::array<Bounds, kBins>, 3> box;
    std::array<std::array<std::uint32_t, kBins>, 3> count{};

    void add(std::span<const ItemRef> items, const Grid& grid) {
        for (const ItemRef& item : items) {
            const Int4 bin = grid.bins(item.centroid());
            for (int axis = 0; axis < 3; ++axis) {
                box[axis][bin[axis]].grow(item.box());
                ++count[axis][bin[axis]];
            }
        }
    }
    void add(const Bins& other) {
        for (int axis = 0; axis < 3; ++axis) {
            for (std::uint32_t b = 0; b < kBins; ++b) {
                box[axis][b].grow(other.box[axis][b]);
                count[axis][b] += other.count[axis][b];
            }
        }
    }
};

/// Left of the cut: bins below `position` along `axis`, or in a sweep the first `position` items.
struct Cut {
    float cost = std::numeric_limits<float>::infinity();
    std::uint32_t imbalance = 0;
    int axis = -1;
    std::uint32_t position = 0;

    // Where areas vanish all costs are equal: then the more even cut keeps the tree shallow.
    [[nodiscard]] bool betterThan(const Cut& other) const {
        return cost < other.cost || (cost == other.cost && imbalance < other.imbalance);
    }
};

Cut makeCut(float leftArea, std::size_t leftCount, float rightArea, std::size_t rightCount, int axis,
            std::uint32_t position) {
    const float cost = leftArea * static_cast<float>(leftCount) + rightArea * static_cast<float>(rightCount);
    const std::size_t imbalance = leftCount > rightCount ? leftCount - rightCount : rightCount - leftCount;
    return {cost, static_cast<std::uint32_t>(imbalance), axis, position};
}

std::size_t chunkCount(std::size_t n) { return (n + kChunk - 1) / kChunk; }

/// Runs body(chunk index, items of the chunk) over fixed chunks, in parallel if there are several.
template <typename Body>
void forChunks(std::size_t n, const Body& body) {
    const auto run = [&](std::size_t c) { body(c, c * kChunk, std::min(n, (c + 1) * kChunk)); };
    if (n <= kChunk) return run(0);
    tbb::parallel_for(std::size_t{0}, chunkCount(n), run);
}

Bins binItems(std::span<const ItemRef> items, const Grid& grid) {
    Bins total;
    if (items.size() <= kChunk) {
        total.add(items, grid);
        return total;
    }
    std::vector<Bins> parts(chunkCount(items.size()));
    forChunks(items.size(), [&](std::size_t c, std::size_t begin, std::size_t end) {
        parts[c].add(items.subspan(begin, end - begin), grid);
    });
    for (const Bins& part : parts) total.add(part);
    return total;
}

Cut bestCut(const Bins& bins, std::size_t n, float areaScale) {
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
        std::array<float, kBins> rightArea{};
        Bounds right, left;
        for (std::uint32_t b = kBins - 1; b > 0; --b) {
            right.grow(bins.box[axis][b]);
            rightArea[b] = halfArea(right, areaScale);
        }
        std::size_t leftCount = 0;
        for (std::uint32_t b = 1; b < kBins; ++b) {
            left.grow(bins.box[axis][b - 1]);
            leftCount += bins.count[axis][b - 1];
            if (leftCount == 0 || bins.count[axis][b - 1] == 0) continue;
            if (leftCount == n) break;
            const Cut cut = makeCut(halfArea(left, areaScale), leftCount, rightArea[b], n - leftCount, axis, b);
            if (cut.betterThan(best)) best = cut;
        }
    }
    return best;
}

/// Sorts the items of a cut to both ends; returns how many are left, and grows both sides' centroid bounds.
std::size_t partitionSerial(std::span<ItemRef> items, const Grid& grid, const Cut& cut, Bounds& left, Bounds& right) {
    const auto position = static_cast<std::int32_t>(cut.position);
    std::size_t i = 0, j = items.size();
    while (true) {
        for (; i < j; ++i) {
            const Float4 c = items[i].centroid();
            if (grid.bin(c, cut.axis) >= position) break;
            left.grow(c);
        }
        for (; i < j; --j) {
            const Float4 c = items[j - 1].centroid();
            if (grid.bin(c, cut.axis) < position) break;
            right.grow(c);
        }
        if (i == j) return i;
        std::swap(items[i], items[j - 1]);
    }
}

struct Run {
    std::size_t begin, end;
};

/// Swaps the items of two lists of runs that hold equally many.
void swapRuns(std::span<ItemRef> items, const std::vector<Run>& a, const std::vector<Run>& b) {
    std::size_t ib = 0, at = b.empty() ? 0 : b[0].begin;
    for (const Run& run : a) {
        for (std::size_t i = run.begin; i < run.end; ++i) {
            while (at == b[ib].end) at = b[++ib].begin;
            std::swap(items[i], items[at++]);
        }
    }
}

/// Partitions fixed chunks in parallel, then exchanges what lies on the wrong side.
SplitResult partitionItems(std::span<ItemRef> items, const Grid& grid, const Cut& cut) {
    struct Part {
        Bounds left, right;
        std::size_t middle = 0;
    };
    std::vector<Part> parts(chunkCount(items.size()));
    forChunks(items.size(), [&](std::size_t c, std::size_t begin, std::size_t end) {
        Part& part = parts[c];
        part.middle = begin + partitionSerial(items.subspan(begin, end - begin), grid, cut, part.left, part.right);
    });
    SplitResult result;
    std::size_t middle = 0;
    for (std::size_t c = 0; c < parts.size(); ++c) {
        middle += parts[c].middle - c * kChunk;
        result.left.centroids.grow(parts[c].left);
        result.right.centroids.grow(parts[c].right);
    }
    std::vector<Run> rightsOnLeft, leftsOnRight;
    for (std::size_t c = 0; c < parts.size(); ++c) {
        const std::size_t begin = c * kChunk, end = std::min(items.size(), begin + kChunk);
        if (parts[c].middle < std::min(end, middle)) rightsOnLeft.push_back({parts[c].middle, std::min(end, middle)});
        if (std::max(begin, middle) < parts[c].middle)
            leftsOnRight.push_back({std::max(begin, middle), parts[c].middle});
    }
    swapRuns(items, rightsOnLeft, leftsOnRight);
    result.left.items = items.first(middle);
    result.right.items = items.subspan(middle);
    return result;
}

SplitResult halves(std::span<ItemRef> items, std::size_t middle) {
    SplitResult result;
    result.left = {items.first(middle), centroidBoundsOf(items.first(middle))};
    result.right = {items.subspan(middle), centroidBoundsOf(items.subspan(middle))};
    return result;
}

/// Items along one axis, in the order of their centroids; equal ones keep their order.
void sortFew(std::span<ItemRef> items, int axis) {
    std::array<float, kSweepItems> key;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const ItemRef item = items[i];
        const float k = item.lo[axis] + item.hi[axis];
        std::size_t j = i;
        for (; j > 0 && key[j - 1] > k; --j) {
            key[j] = key[j - 1];
            items[j] = items[j - 1];
        }
        key[j] = k;
        items[j] = item;
    }
}

/// Tries every cut between items sorted along each axis.
SplitResult splitFew(std::span<ItemRef> items, float areaScale) {
    const std::size_t n = items.size();
    Cut best;
    std::array<std::array<ItemRef, kSweepItems>, 3> sorted;
    for (int axis = 0; axis < 3; ++axis) {
        std::copy(items.begin(), items.end(), sorted[axis].begin());
        const std::span<ItemRef> along(sorted[axis].data(), n);
        sortFew(along, axis);
        std::array<float, kSweepItems> rightArea;
        Bounds right, left;
        for (std::size_t i = n - 1; i > 0; --i) {
            right.grow(along[i].box());
            rightArea[i] = halfArea(right, areaScale);
        }
        for (std::size_t i = 1; i < n; ++i) {
            left.grow(along[i - 1].box());
            const Cut cut =
                makeCut(halfArea(left, areaScale), i, rightArea[i], n - i, axis, static_cast<std::uint32_t>(i));
            if (cut.betterThan(best)) best = cut;
        }
    }
    std::copy_n(sorted[best.axis].begin(), n, items.begin());
    return halves(items, best.position);
}

}  // namespace

Bounds boundsOf(std::span<const ItemRef> items) {
    std::vector<Bounds> parts(std::max<std::size_t>(1, chunkCount(items.size())));
    forChunks(items.size(), [&](std::size_t c, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) parts[c].grow(items[i].box());
    });
    for (const Bounds& part : parts) parts[0].grow(part);
    return parts[0];
}

Bounds centroidBoundsOf(std::span<const ItemRef> items) {
    Bounds bounds;
    for (const ItemRef& item : items) bounds.grow(item.centroid());
    return bounds;
}

SplitResult splitBySah(const SplitRange& range, float areaScale) {
    const std::size_t n = range.items.size();
    if (n == 2) return halves(range.items, 1);
    if (n <= kSweepItems) return splitFew(range.items, areaScale);
    const Grid grid(range.centroids);
    const Cut cut = bestCut(binItems(range.items, grid), n, areaScale);
    return cut.axis < 0 ? halves(range.items, n / 2) : partitionItems(range.items, grid, cut);
}

SplitResult splitByCount(const SplitRange& range) {
    const Float4 extent = range.centroids.hi - range.centroids.lo;
    const int axis = extent[0] >= extent[1] && extent[0] >= extent[2] ? 0 : extent[1] >= extent[2] ? 1 : 2;
    const std::size_t middle = range.items.size() / 2;
    const auto before = [axis](const ItemRef& a, const ItemRef& b) {
        const float ca = a.lo[axis] + a.hi[axis], cb = b.lo[axis] + b.hi[axis];
        return ca < cb || (ca == cb && a.index() < b.index());
    };
    std::nth_element(range.items.begin(), range.items.begin() + static_cast<std::ptrdiff_t>(middle), range.items.end(),
                     before);
    return halves(range.items, middle);
}

}  // namespace vkpt
