/* SplitMix64: G. Steele, D. Lea, C. Flood, "Fast Splittable Pseudorandom Number Generators",
 * OOPSLA 2014. */
#include "random.h"

static uint64_t next(struct random *random)
{
    random->state += UINT64_C(0x9E3779B97F4A7C15);
    uint64_t mixed = (random->state ^ random->state >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    mixed = (mixed ^ mixed >> 27) * UINT64_C(0x94D049BB133111EB);
    return mixed ^ mixed >> 31;
}

struct random random_from(uint64_t seed, uint64_t purpose)
{
    struct random random = {seed};
    random.state = next(&random) ^ purpose;
    random.state = next(&random);
    return random;
}

double random_between(struct random *random, double low, double high)
{
    /* 53 bits are as many as a double holds. */
    return low + (high - low) * 0x1p-53 * (double)(next(random) >> 11);
}

bool random_chance(struct random *random, double probability)
{
    return random_between(random, 0.0, 1.0) < probability;
}
