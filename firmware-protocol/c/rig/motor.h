/* Motors with their amplifiers, their shared supply, and their faults. */
#ifndef MOTOR_H
#define MOTOR_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

void motors_begin(void);

/* Moves the motor of `slot` for one step. `command` [N] is positive upwards, `position` [m] and
 * `velocity` [m/s] of the key are positive downwards; `powered` is `false` while the board is dark.
 * Returns the force on the key [N], positive upwards. */
double motor_step(size_t slot, double command, double position, double velocity, bool powered);

/* Force on the key in the last step [N], positive upwards. */
double motor_force(size_t slot);

/* Current [A], positive for a force upwards of a motor that is wired correctly. */
double motor_current(size_t slot);

/* Temperature of the winding [°C]. */
double motor_temperature(size_t slot);

#endif
