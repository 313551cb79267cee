/* Encoders of the keys, and the faults of the encoder in slot 0. */
#ifndef ENCODER_H
#define ENCODER_H

#include <stddef.h>
#include <stdint.h>

void encoders_begin(uint64_t seed);

/* Stores the place of the key in slot 0, where some faults keep the encoder. */
void encoder_fault_begins(double position);

/* Reads the encoder of a key at `position` [m] with `velocity` [m/s]. */
void encoder_read(size_t slot, double position, double velocity);

/* Marks the last readings as samples for the host: some faults act on samples. */
void encoder_sample(void);

/* Last reading [counts], and velocity [m/s]. */
int32_t encoder_counts(size_t slot);
double encoder_velocity(size_t slot);

#endif
