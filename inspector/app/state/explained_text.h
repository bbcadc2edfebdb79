#pragma once

#include <string>
#include <vector>

#include "state/state.h"

namespace raytree::inspector {

/// What a feature says in words and numbers.
struct ExplainedSection {
    enum class Picture { none, depth, time, accuracy };
    struct Row {
        std::vector<std::string> cells;
        bool strong = false;  ///< what counts in the end, or what is shown just now
        bool faint = false;   ///< not there yet
    };
    struct Link {
        std::string words, command;
    };

    std::string title;
    std::vector<std::string> sentences;
    std::vector<std::string> header;  ///< of the columns
    std::vector<Row> rows;
    std::vector<Link> links;          ///< commands that fit here
    Picture picture = Picture::none;  ///< that belongs beside it
};

/// A section for each feature that is shown.
std::vector<ExplainedSection> explained_text(const State& state);

}  // namespace raytree::inspector
