#include "state/tree_question.h"

#include <new>
#include <utility>

namespace raytree::inspector {
namespace {

using What = Contrast::What;

TreeSource source(const TreeQuestion& question, Pixel pixel,
                  std::shared_ptr<const Document> document) {
    return {std::move(document),  pixel,           nullptr,
            "raytree's own tree", question.bounds, question.neighbours};
}

/// The tree that is to be shown, and what it is to be laid over.
std::pair<TreeSource, std::optional<Comparison>> sources(const TreeQuestion& question) {
    const auto& against = question.against;
    TreeSource shown = source(question, question.pixel, question.document);
    if (!against || (against->what == What::file && against->pixel != question.pixel)) {
        if (!question.before) {
            return {shown, std::nullopt};
        }
        return {shown,
                Comparison{source(question, question.pixel, question.before), What::cut, false}};
    }
    TreeSource reference = shown;
    switch (against->what) {
        case What::file:
            reference.recorded = against->reference;
            shown.recorded = against->subject;
            shown.name = name_of(*against->subject);
            if (against->reference) {
                reference.name = name_of(*against->reference);
            }
            break;
        case What::pixel:
            reference.pixel = against->pixel;
            reference.name = "pixel " + text_of(against->pixel);
            shown.name = "pixel " + text_of(question.pixel);
            break;
        default:
            reference.document = question.before;
            reference.name = "before the change";
            shown.name = "after the change";
    }
    if (against->swapped) {
        std::swap(reference, shown);
    }
    return {std::move(shown), Comparison{std::move(reference), against->what, against->swapped}};
}

}  // namespace

TracedPixel answer(const TreeQuestion& asked, const std::stop_token& stop) {
    TreeQuestion question = asked;
    TracedPixel traced{question.document, nullptr, {}};
    try {
        if (question.values) {
            traced.document = question.document = with_values(question.document, *question.values);
        }
        const auto [shown, with] = sources(question);
        traced.tree = std::make_shared<const PixelTree>(with ? laid_over(shown, *with, stop)
                                                             : tree_from(shown, stop));
    } catch (const InputError& error) {
        traced.failure = error.what();
    } catch (const std::bad_alloc&) {
        traced.failure = "There is too little memory for the tree of this pixel.";
    }
    return traced;
}

std::string name_of(const check::Submission& recorded) {
    return std::filesystem::path(recorded.file).filename().string();
}

}  // namespace raytree::inspector
