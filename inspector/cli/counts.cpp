#include "counts.h"

#include "formats/json_text.h"

namespace raytree::cli {

std::string counts_json(const RayCounts& counts) {
    JsonWriter json;
    json.begin_object(JsonWriter::Layout::block);
    for (const RayKind kind :
         {RayKind::primary, RayKind::reflected, RayKind::refracted, RayKind::shadow}) {
        json.key(word_of(kind)).begin_object();
        json.member("rays", counts[kind].rays);
        json.member(kind == RayKind::shadow ? "blocked" : "hits", counts[kind].hits);
        json.end_object();
    }
    json.key("skipped").begin_object();
    for (const ReasonText& text : reason_texts()) {
        // The others end a ray that was sent.
        if (text.reason <= Reason::ray_budget) {
            json.member(text.word, counts.skipped[static_cast<std::size_t>(text.reason)]);
        }
    }
    json.end_object();
    json.end_object();
    return json.take();
}

}  // namespace raytree::cli
