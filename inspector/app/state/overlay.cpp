#include "state/overlay.h"

#include <algorithm>
#include <new>

#include "state/explanation.h"

namespace raytree::inspector {
namespace {

std::uint32_t cell_of(const Colour8& colour) {
    std::uint32_t cell = 0xFF;
    for (const std::uint8_t channel : colour) {
        cell = cell << 8 | channel;
    }
    return cell;
}

struct AnswersLook {
    ShadowAnswers answers;
    std::string_view name;
    Colour8 colour;
};
/// The colours of the two errors are distinct to the colour-blind as well (as reason_colour).
constexpr AnswersLook answers_looks[] = {
    {ShadowAnswers::none, "not asked", {0x1B, 0x1F, 0x24}},
    {ShadowAnswers::both_lit, "lit, both say", {0xE9, 0xE4, 0xD0}},
    {ShadowAnswers::both_dark, "dark, both say", {0x6A, 0x72, 0x7C}},
    {ShadowAnswers::wrongly_dark, "wrongly dark", {0xD5, 0x5E, 0x00}},
    {ShadowAnswers::wrongly_lit, "wrongly lit", {0x56, 0xB4, 0xE9}},
};

void paint_kinds(Overlay& overlay) {
    for (const double value : overlay.values) {
        const auto kind = std::ranges::find(overlay.kinds, value, &OverlayKind::value);
        overlay.cells.push_back(cell_of(kind->colour));
    }
}

}  // namespace

const OverlayKind* Overlay::kind_at(Pixel pixel) const {
    const auto kind = std::ranges::find(kinds, at(pixel), &OverlayKind::value);
    return kind == kinds.end() ? nullptr : &*kind;
}

Overlay make_overlay(Measurement measured, Measure measure) {
    Overlay overlay{measure, measured.picture.width, measured.picture.height, {}, {}, {}, {}};
    overlay.range = map_range(measured.map, measure);
    overlay.values = std::move(measured.map);
    overlay.cells.reserve(overlay.values.size());
    if (measure == Measure::ended) {
        for (const auto& [reason, pixels] : reasons_in(overlay.values)) {
            overlay.kinds.push_back(
                {plain_word(reason), reason_colour(reason), static_cast<double>(reason), pixels});
        }
        paint_kinds(overlay);
        return overlay;
    }
    for (const double value : overlay.values) {
        overlay.cells.push_back(cell_of(map_colour(value, measure, overlay.range)));
    }
    return overlay;
}

Overlay make_overlay(const std::vector<ShadowAnswers>& answers, const Camera& camera,
                     const lesson::DepthShown& of) {
    Overlay overlay{of, camera.width, camera.height, {}, {}, {}, {}};
    for (const ShadowAnswers answer : answers) {
        overlay.values.push_back(static_cast<double>(answer));
    }
    for (const AnswersLook& look : answers_looks) {
        const auto pixels = static_cast<std::size_t>(std::ranges::count(answers, look.answers));
        if (pixels > 0) {
            overlay.kinds.push_back(
                {std::string(look.name), look.colour, static_cast<double>(look.answers), pixels});
        }
    }
    std::ranges::stable_sort(overlay.kinds, std::greater(), &OverlayKind::pixels);
    paint_kinds(overlay);
    return overlay;
}

std::string title_of(const Overlay& overlay) {
    if (const auto* const depth = std::get_if<lesson::DepthShown>(&overlay.of)) {
        return "Depth picture beside shadow rays: " + depth->light;
    }
    std::string title(text_of(std::get<Measure>(overlay.of)));
    title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
    return title;
}

std::string amount_text(const Overlay& overlay, double amount) {
    return measured_text(amount, std::get<Measure>(overlay.of));
}

std::string value_text(const Overlay& overlay, Pixel pixel) {
    const OverlayKind* const kind = overlay.kind_at(pixel);
    return kind ? kind->name : amount_text(overlay, overlay.at(pixel));
}

std::string plain_word(Reason reason) {
    std::string word(word_of(reason));
    std::ranges::replace(word, '_', ' ');
    return word;
}

OverlayRender::OverlayRender(std::shared_ptr<const Document> document, OverlayOf of,
                             const RightOfWay* window)
    : document_(std::move(document)), of_(std::move(of)), window_(window) {
    thread_ = std::thread([this] { run(); });
}

OverlayRender::~OverlayRender() {
    cancel();
    thread_.join();
}

Overlay OverlayRender::measured(Measure measure) {
    // One core is left to the window.
    const int cores = static_cast<int>(std::thread::hardware_concurrency());
    const RenderOptions options{std::max(1, cores - 1), [this](double share) {
                                    share_ = share;
                                    if (window_) {
                                        window_->give();
                                    }
                                    return !cancelled_;
                                }};
    return make_overlay(render_measured(document_->world(), measure, options), measure);
}

Overlay OverlayRender::compared(const lesson::DepthShown& depth) const {
    const auto light = place_of_light(document_->scene(), depth.light);
    if (!light) {
        throw InputError("", "light", "the scene has no light '" + depth.light + "'");
    }
    const DepthPicture picture(document_->world(), *light, depth.size);
    return make_overlay(shadow_answers(document_->world(), *light, picture, depth.bias),
                        document_->scene().camera, depth);
}

void OverlayRender::run() {
    try {
        const Measure* const measure = std::get_if<Measure>(&of_);
        auto overlay = std::make_shared<const Overlay>(
            measure ? measured(*measure) : compared(std::get<lesson::DepthShown>(of_)));
        if (!cancelled_) {
            overlay_ = std::move(overlay);
        }
    } catch (const InputError& error) {
        failure_ = error.what();
    } catch (const std::bad_alloc&) {
        failure_ = "There is too little memory to measure this.";
    }
    stopped_ = true;
}

}  // namespace raytree::inspector
