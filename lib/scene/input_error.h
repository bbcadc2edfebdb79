#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace raytree {

/// One thing wrong with an input: where it is and what is the matter.
struct Mistake {
    std::string file;   ///< as the user named it; may be empty
    std::string place;  ///< a JSON pointer, or "line 3, column 7"; empty for the file as a whole
    std::string text;   ///< what was found and what is allowed

    /// "file: place: text", leaving out what is empty; one line that any terminal can show,
    /// whatever the file holds.
    std::string message() const;
};

/// Bad input. Caught in `main` alone; its `what()` has a line for each mistake.
class InputError : public std::runtime_error {
  public:
    explicit InputError(std::vector<Mistake> mistakes);
    InputError(std::string file, std::string place, std::string text)
        : InputError({Mistake{std::move(file), std::move(place), std::move(text)}}) {}

    const std::vector<Mistake>& mistakes() const { return mistakes_; }

  private:
    std::vector<Mistake> mistakes_;
};

}  // namespace raytree
