#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

#include "check/conventions.h"
#include "check/names.h"

namespace raytree::check {

/// What to judge by: the scene as a set of conventions has it, ready for tracing, and the laws.
struct Rulebook {
    Rulebook(const Scene& scene, Choices choices);
    Rulebook(const Rulebook&) = delete;
    Rulebook& operator=(const Rulebook&) = delete;

    const Choices choices;
    const Scene scene;
    const Place place;
    const Names names;
    const Laws laws;
};

/// The rulebooks of one scene, each made when it is first asked for; from several threads at once.
class Rulebooks {
  public:
    /// `course_text`: the scene's settings are those of the course text format. The scene given
    /// must outlive it.
    Rulebooks(const Scene& scene, bool course_text);

    Choices choices_of(const Profile& profile) const;
    const Rulebook& of(const Choices& choices) const;
    const Rulebook& of(const Profile& profile) const { return of(choices_of(profile)); }
    const Rulebook& lecture() const { return of(profiles().front()); }

    /// What other courses do: one convention of `base` exchanged, those first that say what they
    /// are and are not only "as the scene says"; then whole courses.
    std::vector<Choices> alternatives(const Choices& base) const;

    /// The conventions of `choices` that are others than those of `base`, but for those that change
    /// nothing of this scene.
    Choices differences(const Choices& choices, const Choices& base) const;

  private:
    const Scene& scene_;
    bool course_text_;
    mutable std::mutex mutex_;
    mutable std::unordered_map<std::string, std::unique_ptr<const Rulebook>> made_;
};

}  // namespace raytree::check
