#include "state/overlay.h"

#include <algorithm>

namespace raytree::inspector {

Overlay make_overlay(Measurement measured, Measure measure) {
    Overlay overlay{measure, measured.picture.width, measured.picture.height, {}, {}, {}, {}};
    overlay.range = map_range(measured.map, measure);
    overlay.cells.reserve(measured.map.size());
    for (const double value : measured.map) {
        std::uint32_t cell = 0xFF;
        for (const std::uint8_t channel : map_colour(value, measure, overlay.range)) {
            cell = cell << 8 | channel;
        }
        overlay.cells.push_back(cell);
    }
    if (measure == Measure::ended) {
        overlay.reasons = reasons_in(measured.map);
    }
    overlay.values = std::move(measured.map);
    return overlay;
}

std::string value_text(const Overlay& overlay, Pixel pixel) {
    const double value = overlay.at(pixel);
    return overlay.measure == Measure::ended ? plain_word(static_cast<Reason>(value))
                                             : measured_text(value, overlay.measure);
}

std::string plain_word(Reason reason) {
    std::string word(word_of(reason));
    std::ranges::replace(word, '_', ' ');
    return word;
}

OverlayRender::OverlayRender(std::shared_ptr<const Document> document, Measure measure)
    : document_(std::move(document)), measure_(measure) {
    thread_ = std::thread([this] { run(); });
}

OverlayRender::~OverlayRender() {
    cancel();
    thread_.join();
}

void OverlayRender::run() {
    // One core is left to the window.
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    const RenderOptions options{std::max(1, cores - 1), [this](double share) {
                                    share_ = share;
                                    return !cancelled_;
                                }};
    try {
        Measurement measured = render_measured(document_->world(), measure_, options);
        if (!cancelled_) {
            overlay_ = std::make_shared<Overlay>(make_overlay(std::move(measured), measure_));
        }
    } catch (const InputError& error) {
        failure_ = error.what();
    }
    stopped_ = true;
}

}  // namespace raytree::inspector
