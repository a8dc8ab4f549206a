/* A depth-first explorer of numbered rooms, with the blocking interface of the skeleton in C,
 * which is included by the command that builds it. */


enum { ROOMS = 64, DOORS = 64 };

struct explored {
    allworlds_percept seen[ROOMS]; /* on entering for the first time, by which door 0 was used */
    int degree[ROOMS], room[ROOMS][DOORS], door[ROOMS][DOORS];
};

/* Depth first; returns the door of the room by which the robot stands. */
static int search(struct explored *e, int room, int door)
{
    for (int k = 0; k < e->degree[room]; k++) {
        if (e->room[room][k])
            continue;
        e->room[room][k] = -1;
        allworlds_percept there = allworlds_move(k - door);
        int next = there.marks, in = 0, known = e->degree[next];
        if (known) {
            in = ((e->seen[next].bearing - there.bearing) % there.degree + there.degree) % there.degree;
        } else {
            e->seen[next] = there;
            e->degree[next] = there.degree;
        }
        e->room[room][k] = next, e->door[room][k] = in;
        e->room[next][in] = room, e->door[next][in] = k;
        int at = known ? in : search(e, next, in);
        allworlds_move(in - at);
        door = k;
    }
    return door;
}

static void explore(allworlds_percept first, int32_t told)
{
    struct explored e;
    int32_t sigma[2 * DOORS], alpha[2 * DOORS], number[ROOMS][DOORS], darts = 0;
    (void)told;
    memset(&e, 0, sizeof e);
    e.seen[first.marks] = first;
    e.degree[first.marks] = first.degree;
    int door = search(&e, first.marks, 0);
    for (int room = 0; room < ROOMS; room++)
        for (int k = 0; k < e.degree[room]; k++)
            number[room][k] = darts++;
    for (int room = 0; room < ROOMS; room++)
        for (int k = 0; k < e.degree[room]; k++) {
            sigma[number[room][k]] = number[room][(k + 1) % e.degree[room]];
            alpha[number[room][k]] = number[e.room[room][k]][e.door[room][k]];
        }
    allworlds_found(darts, sigma, alpha, number[first.marks][door]);
}
