// What a check compared: how much, how far off the worst of it was, and the first thing that lies beyond its tolerance.
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vkpt {

/// One thing a check compares, over all its inputs.
struct Quantity {
    std::string name;
    std::uint64_t compared = 0;
    std::uint64_t outside = 0;  ///< beyond the tolerance
    std::uint64_t excused = 0;  ///< beyond it, but the reference does the same for an input within rounding of this one
    double worst = 0;           ///< largest error among those inside, as a share of its tolerance; 0 for equalities
};

/// A number worth telling that is no comparison.
struct Figure {
    std::string name;
    double value = 0;
    std::string text;  ///< the value, rounded, with its unit
};

/// The first value beyond its tolerance.
struct Disagreement {
    std::string quantity;  ///< which one
    std::string where;     ///< for which input
    std::string what;      ///< actual and expected value
};

[[nodiscard]] inline std::string show(const std::string& text) { return text; }
template <class T>
[[nodiscard]] std::string show(const T& value) {
    return fmt::format("{}", value);
}
template <int N, class T>
[[nodiscard]] std::string show(const glm::vec<N, T>& v) {
    std::string text;
    for (int i = 0; i < N; ++i) text += fmt::format("{}{}", i == 0 ? "(" : ", ", v[i]);
    return text + ")";
}

/// Collects comparisons. Every comparison returns whether it holds, and counts either way.
class Findings {
public:
    using Describe = std::function<std::string(std::size_t)>;

    /// While it lives, a disagreement is located by the words of `describe`.
    class InputScope {
    public:
        InputScope(Findings& findings, Describe describe) : findings_(findings) {
            findings_.describe_ = std::move(describe);
        }
        ~InputScope() { findings_.describe_ = nullptr; }
        InputScope(const InputScope&) = delete;
        InputScope& operator=(const InputScope&) = delete;

    private:
        Findings& findings_;
    };

    /// `describe(i)` tells in words what input i is; it is called for the first disagreement only.
    [[nodiscard]] InputScope inputs(Describe describe) { return {*this, std::move(describe)}; }
    /// The input that the following comparisons are about.
    void at(std::size_t input) { input_ = input; }

    /// |actual - expected| <= absolute + relative |expected| in every component; never for NaN.
    template <int N, class A, class B>
    bool near(std::string_view quantity, const glm::vec<N, A>& actual, const glm::vec<N, B>& expected, double absolute,
              double relative = 0) {
        double worst = 0;
        for (int i = 0; i < N; ++i)
            worst = std::fmax(worst, shareOfTolerance(double(actual[i]), double(expected[i]), absolute, relative));
        if (count(quantity, worst)) return true;
        return disagree(quantity, [&] { return missText(actual, expected, absolute, relative); });
    }
    bool near(std::string_view quantity, double actual, double expected, double absolute, double relative = 0) {
        if (count(quantity, shareOfTolerance(actual, expected, absolute, relative))) return true;
        return disagree(quantity, [&] { return missText(actual, expected, absolute, relative); });
    }

    template <class A, class B>
    bool equal(std::string_view quantity, const A& actual, const B& expected) {
        if (count(quantity, actual == expected ? 0 : kBeyond)) return true;
        return disagree(quantity, [&] { return fmt::format("{} instead of {}", show(actual), show(expected)); });
    }
    bool holds(std::string_view quantity, bool condition, std::string_view otherwise = "does not hold") {
        if (count(quantity, condition ? 0 : kBeyond)) return true;
        return disagree(quantity, [&] { return std::string(otherwise); });
    }
    /// Counts something beyond its tolerance that rounding explains. A check bounds how much of it there may be.
    void excuse(std::string_view quantity);
    /// Counts at once what was compared elsewhere, and how much of it was excused.
    void tally(std::string_view quantity, std::uint64_t compared, std::uint64_t excused);
    /// A count that must be reached, or not exceeded, for the check to mean anything.
    bool atLeast(std::string_view what, double actual, double least);
    bool atMost(std::string_view what, double actual, double most);
    void figure(std::string name, double value, std::string text) {
        figures_.push_back({std::move(name), value, std::move(text)});
    }
    /// The check cannot judge, for a reason that lies in what it is asked to judge.
    void refuse(std::string reason) { refusal_ = std::move(reason); }
    /// Takes over what another collected, under names that begin with `prefix`.
    void add(std::string_view prefix, const Findings& other);
    /// A disagreement that was found elsewhere.
    void disagree(std::string_view quantity, std::string where, std::string what);

    [[nodiscard]] const std::vector<Quantity>& quantities() const { return quantities_; }
    [[nodiscard]] const std::vector<Figure>& figures() const { return figures_; }
    /// Empty unless the check refused.
    [[nodiscard]] const std::string& refusal() const { return refusal_; }
    [[nodiscard]] const std::optional<Disagreement>& disagreement() const { return disagreement_; }
    [[nodiscard]] std::uint64_t compared() const;
    [[nodiscard]] std::uint64_t excused() const;
    [[nodiscard]] double worst() const;

    /// The error as a share of what is allowed: at most 1 is inside. NaN anywhere gives infinity.
    [[nodiscard]] static double shareOfTolerance(double actual, double expected, double absolute, double relative);

private:
    static constexpr double kBeyond = 2;

    Quantity& quantity(std::string_view name);
    bool count(std::string_view name, double share);
    template <class What>
    bool disagree(std::string_view name, const What& what) {
        if (!disagreement_) disagree(name, describe_ ? describe_(input_) : std::string(), what());
        return false;
    }
    template <class A, class B>
    static std::string missText(const A& actual, const B& expected, double absolute, double relative) {
        return fmt::format("{} instead of {} (tolerance {:.1g}{})", show(actual), show(expected), absolute,
                           relative > 0 ? fmt::format(" and {:.1g} of the value", relative) : "");
    }

    std::vector<Quantity> quantities_;
    std::vector<Figure> figures_;
    std::string refusal_;
    std::optional<Disagreement> disagreement_;
    Describe describe_;
    std::size_t input_ = 0;
};

}  // namespace vkpt
