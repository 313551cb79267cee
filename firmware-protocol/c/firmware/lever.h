/* Mechanics of the simulated key and of the finger that plays it; no motor, no encoder.
 *
 * Like crates/haptics/src/plant, in single precision and with its own step. `plant.c` and the rig
 * in ../rig add a motor and an encoder, each its own.
 */
#ifndef LEVER_H
#define LEVER_H

#include "plant.h"

/* Direction in which a key at rest starts to move under `force` [N], up positive; 0 if it stays. */
float lever_breakaway(float position, float force);

/* Moves the key for one step under `force` [N], up positive. */
void lever_step(struct plant_key *key, float force);

/* Moves the finger of `key` for one step towards `command`; returns its push on the key [N]. */
float lever_touch(struct plant_key *key, struct command command);

/* Moves the finger along the gestures of `key`, if one plays; returns its push on the key [N]. */
float lever_play(struct plant_key *key, uint32_t now_us);

/* Takes the finger away from the key. */
void lever_leave(struct plant_key *key);

#endif
