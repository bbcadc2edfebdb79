#pragma once

#include <optional>
#include <string>

#include "lesson/lesson.h"

/// What the state tells its views.
namespace raytree::inspector {

/// What is asked of the views once; nothing of it stays in the state.
enum class Request {
    through_camera,
    from_side,
    onto_hit,
    fit_tree,
    fit_selection,
    fit_picture,
    picture_closer,
    picture_further,
    picture_values,
    view_closer,
    view_further,
    turn_left,
    turn_right,
    turn_up,
    turn_down,
    export_picture,
    export_window,
    export_view,
    copy_window,
    copy_view,
    copy_text,
    copy_number,
    copy_rows,
    copy_table,
    choose_columns,
    fit_diagram,
    diagram_closer,
    diagram_further,
    cheat_sheet,
    next_pane,
    previous_pane,
    save_scene_as,
    quit
};

/// What has changed since a view last looked.
struct Changes {
    bool document = false;
    bool tree = false;  ///< pixel, tree, and so the selection
    bool selection = false;
    bool look = false;
    bool tree_pane = false;
    bool table = false;
    bool message = false;
    bool values = false;    ///< the document is the same scene with other values
    bool coats = false;     ///< and its surfaces look different
    bool playback = false;  ///< how far the tree is stepped through
    bool side_pane = false;
    bool lesson = false;     ///< the lesson, its step, or what has been answered
    bool explained = false;  ///< what is shown besides the rays
    /// From where the 3D view is to look at things.
    std::optional<lesson::FreeView> view_from = std::nullopt;
    std::optional<Request> request = std::nullopt;
    std::string text = {};  ///< of a request: the file to write, or the text to copy
};

}  // namespace raytree::inspector
