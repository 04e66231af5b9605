#include "cli/fill_film.h"

#include <algorithm>

namespace vkpt {
namespace {

using Clock = std::chrono::steady_clock;

Clock::time_point after(double seconds) {
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

bool isOver(const FillControl& control) {
    return (control.stop && control.stop->load()) || (control.deadline && Clock::now() >= *control.deadline);
}

}  // namespace

RenderReport fillFilm(FilmRecord& record, SceneRenderer& renderer, const SampleRanges& missing,
                      const FillControl& control) {
    const std::uint64_t pixels = record.film.sums.size(), total = pixels * countSamples(missing);
    const bool saves = control.checkpointSeconds && control.save;
    RenderReport report;
    std::uint64_t done = 0;
    RenderControl pass;
    pass.stop = control.stop;
    pass.progress = [&](std::uint64_t paths, std::uint64_t) {
        if (control.progress) control.progress(done + paths, total);
    };
    for (SampleRange range : missing) {
        while (range.begin < range.end) {
            pass.deadline = control.deadline;
            if (saves) {
                const auto next = after(*control.checkpointSeconds);
                pass.deadline = control.deadline ? std::min(next, *control.deadline) : next;
            }
            RenderReport part;
            const Film film = renderer.render(range, pass, part);
            addSamples(record, film, part.backend, part.device, part.driver);
            addReport(report, part);
            range.begin = film.sampleEnd();
            done += pixels * film.samples();
            if (isOver(control)) return report;
            if (saves && done < total) control.save(record);
        }
    }
    return report;
}

}  // namespace vkpt
