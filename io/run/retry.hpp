// Going back: the good states of a run, and what happens when the watch (core/watch/) sees that it has
// failed. All functions are collective.
#pragma once
#include "io/run/run_state.hpp"

namespace thaw {

/// After the world was begun or resumed: the first good state, or where the one is to which a retry would go
/// back.
void beginRetries(Run& run);

/// A good state may be taken now: at steps that are multiples of Numerics::retryEvery, so that it depends
/// neither on ranks nor on clocks.
bool goodStateDue(const Run& run);

/// The watch's look at the books, where a good state is due; then acceptGoodState keeps it. In between,
/// frames may be written.
Alarm lookAtBooks(Run& run);
void acceptGoodState(Run& run);

/// May a checkpoint be written now without a good state beside it? Periodic checkpoints wait until it may.
bool atGoodState(const Run& run);

/// Writes the good state beside the checkpoint of a run that stops after it, unless it is there already.
void leaveGoodState(Run& run);

/// The watch has seen a failure in the step that has just been done. True: the world is back at the last good
/// state and goes on with half the step; the frames after it are to be written again. False: tries are used
/// up; the message was printed, `why` is for the summary, and the last good state is a checkpoint.
bool goBack(Run& run, const StepOutcome& failed, std::string& why);

}  // namespace thaw
