/* The scripted finger on the key in slot 0. */
#ifndef FINGER_H
#define FINGER_H

#include "../firmware/gesture.h"

/* Chooses the script and the seed of its tremor; returns `false` if there is no such script. */
bool finger_begin(const char *script, uint64_t seed);

/* Name of the script. */
const char *finger_script(void);

/* Command of the muscle at `us` after power on. Returns `false` if the finger is away.
 * `lands` is `true` if the finger starts a gesture, and is placed where the command has it. */
bool finger_command(uint64_t us, struct command *command, bool *lands);

#endif
