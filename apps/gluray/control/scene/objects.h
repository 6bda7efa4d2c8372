// gluray objects and gluray pick: the surfaces that a program draws.
#pragma once
#include "command_line.h"
#include "control/one_program.h"

namespace gluray::launcher {

/// The program's objects, as it sends them, in the order of their numbers. Throws.
nlohmann::json objectsOf(HubSession& hub, const RunningProgram& program);

/// The number of an object. Throws where the entry is none.
int64_t objectNumber(const nlohmann::json& object);

/// Where the point of an answer to `pick` lies in its view: shares of the view's width and height from its
/// lower left corner; empty: nothing is there. Throws.
std::vector<double> shareIn(const nlohmann::json& found);

/// Prints tables of objects. Returns the exit code.
int listObjects(const CommandLine& line);

/// Prints what is seen at a point of a program's image. Returns the exit code.
int pickObject(const CommandLine& line);

}  // namespace gluray::launcher
