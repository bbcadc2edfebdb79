#pragma once

#include "check/catalogue.h"
#include "check/check.h"

namespace raytree::check {

/// Looks for the mistakes that give the submission's numbers: the whole of it is worked through
/// again under each entry of the catalogue. `options` are those by which the report's findings were
/// found; its `findings` are told apart by the mistakes that explain them.
void diagnose(const Place& place, const Names& names, const Laws& laws,
              const Submission& submission, const ReplayOptions& options, Report& report);

/// The mistake with its words, neither sure nor tied.
NamedMistake named_mistake(const MistakeRow& row);

}  // namespace raytree::check
