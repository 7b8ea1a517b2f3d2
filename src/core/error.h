// The one exception of the program. It is thrown where bad input enters (loaders, G-code, job
// files, command line) and caught in main, which prints the message as one line and exits with the
// status.
//
//     throw Error("part.stl: 3 bytes are too few for a mesh; is the download complete?");
#pragma once
#include <stdexcept>
#include <string>

namespace bead {

// The values are the program's exit statuses.
enum class Fault { other = 1, usage = 2, input = 3, infeasible = 4, not_converged = 5 };

class Error : public std::runtime_error {
  public:
    // The message says what, where (file:line or setting) and what to do, in one line.
    explicit Error(const std::string& message, Fault fault = Fault::input)
        : std::runtime_error(message), fault_(fault) {}
    [[nodiscard]] Fault fault() const { return fault_; }

  private:
    Fault fault_;
};

}  // namespace bead
