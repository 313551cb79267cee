/* Numbers that look like chance; a seed gives the same numbers on every machine. */
#ifndef RANDOM_H
#define RANDOM_H

#include <stdbool.h>
#include <stdint.h>

struct random {
    uint64_t state;
};

/* Each `purpose` has numbers of its own, so that a fault of the link leaves the finger alone. */
struct random random_from(uint64_t seed, uint64_t purpose);

/* Returns a number from `low` up to, but not including, `high`. */
double random_between(struct random *random, double low, double high);

/* Returns `true` with this probability. */
bool random_chance(struct random *random, double probability);

#endif
