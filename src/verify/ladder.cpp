#include "verify/ladder.h"

#include <chrono>

namespace vkpt {

const CheckResult* LadderResult::failure() const {
    return checks.empty() || checks.back().agrees() ? nullptr : &checks.back();
}

LadderResult climb(VerifyContext& context, const LadderObserver& observer) {
    using Clock = std::chrono::steady_clock;
    LadderResult result;
    for (const Check& check : verifyChecks()) {
        if (observer.before) observer.before(check);
        const auto start = Clock::now();
        CheckResult& row = result.checks.emplace_back();
        row.check = &check;
        check.run(context, row.findings);
        row.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        if (observer.after) observer.after(row);
        if (!row.agrees()) break;
    }
    return result;
}

Json ladderJson(const LadderResult& result) {
    Json list = Json::array();
    for (const CheckResult& row : result.checks) {
        const Findings& f = row.findings;
        Json json{{"rung", kRungs[static_cast<std::size_t>(row.check->rung)].name},
                  {"check", row.check->name},
                  {"about", row.check->about},
                  {"result", !row.agrees() ? "disagrees" : (f.refusal().empty() ? "agrees" : "refused")},
                  {"compared", f.compared()},
                  {"excused", f.excused()},
                  {"worstShareOfTolerance", f.worst()},
                  {"seconds", row.seconds}};
        for (const Figure& figure : f.figures()) json["figures"][figure.name] = figure.value;
        for (const Quantity& q : f.quantities())
            json["quantities"].push_back({{"name", q.name},
                                          {"compared", q.compared},
                                          {"outside", q.outside},
                                          {"excused", q.excused},
                                          {"worstShareOfTolerance", q.worst}});
        if (!f.refusal().empty()) json["refusal"] = f.refusal();
        if (const auto& d = f.disagreement())
            json["disagreement"] = {{"quantity", d->quantity}, {"where", d->where}, {"what", d->what}};
        list.push_back(std::move(json));
    }
    return list;
}

}  // namespace vkpt
