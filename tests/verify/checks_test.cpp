// Every check of the table agrees, and the validation layers stay silent meanwhile. A new check is covered with no
// edit here.
#include "verify/check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "verify/test_context.h"

namespace vkpt {

void PrintTo(const Check& check, std::ostream* out) { *out << check.name; }

namespace {

class EveryCheck : public testing::TestWithParam<Check> {
protected:
    /// One for all tests: probes are compiled once. Ended before the process is, whose drivers may be gone by then.
    static void SetUpTestSuite() { context_.emplace(everyFeature(), smallOptions(), testConfig(true)); }
    static void TearDownTestSuite() { context_.reset(); }
    static VerifyContext& context() { return *context_; }

private:
    inline static std::optional<VerifyContext> context_;
};

TEST_P(EveryCheck, Agrees) {
    Findings findings;
    GetParam().run(context(), findings);
    if (const auto& d = findings.disagreement()) ADD_FAILURE() << d->quantity << ": " << d->what << "\n" << d->where;
    EXPECT_GT(findings.compared(), 0U) << "nothing was compared";
    EXPECT_EQ(context().validationMessages(), 0U);
}

std::string testName(const testing::TestParamInfo<Check>& test) {
    std::string name(test.param.name);
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Ladder, EveryCheck, testing::ValuesIn(verifyChecks().begin(), verifyChecks().end()), testName);

}  // namespace
}  // namespace vkpt
