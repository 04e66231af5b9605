// The page of a report. HTML, style and script stand in report_page.cpp; nothing is loaded from elsewhere.
#pragma once
#include <string>
#include <vector>

#include "base/json.h"
#include "film/encode.h"
#include "verify/ladder.h"

namespace vkpt {

/// Two pictures of the same size under one slider.
struct ImagePair {
    std::string name, about;
    double aspect = 1;        ///< width / height
    Bytes device, reference;  ///< PNG
};

struct HeatPicture {
    std::string name, about;
    Bytes png;
};

struct ReportPage {
    std::string title, device;
    const LadderResult& ladder;
    std::vector<ImagePair> pairs;
    std::vector<HeatPicture> heats;
    Json settings;
};

[[nodiscard]] std::string reportHtml(const ReportPage& page);

}  // namespace vkpt
