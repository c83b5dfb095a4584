/* tuning.h - the constants that were found by measuring, with their units and what was seen. No
 * hit depends on them: they decide what is tried first and what is left out. Shared by host and
 * device. docs/tuning.md is the whole record; its figures, and these, are from 2 cores with
 * AVX-512 and PoCL 3.1.
 */
#ifndef RSH_TUNING_H
#define RSH_TUNING_H

/* Sorting triangles and rays: order/, bvh/order.cl, rays/sort_rays.cl. */

/* Ranges of 16 elements that a work-item looks at before it makes keys of all. */
#define RSH_SAMPLES 64

/* A range of 16 triangles is incoherent when the surface of its box is so many times the sum of
 * its triangles' boxes: neighbours on a surface share theirs, strangers span the space between
 * them. A sixth of all ranges is above it in meshes of grids, a third and more in scenes that
 * were modelled part by part. */
#define RSH_INCOHERENT_SURFACE 1.5f

/* Of so many sampled ranges of triangles, how many may be incoherent before each cell is sorted
 * as well; some always are, where one object ends and the next begins. Sorting everything takes
 * more than half of a frame at 700 K triangles. */
#define RSH_INCOHERENT_TRIANGLES(sampled) ((sampled) / 4)

/* Bits of a coordinate where cells are sorted as well; 7 is what order/hilbert.h has room
 * for. */
#define RSH_FINE_BITS 7

/* A triangle is large when its box is longer than this, in lengths of the scene's box. Large
 * ones come first: each box that holds one among small ones would be large. More classes of
 * sizes made more nodes in every scene. */
#define RSH_LARGE 0.125f

/* A range of 16 rays is incoherent when its origins span more than this of what all origins do;
 * where all rays start in one point, when its directions span more than this of theirs. Of rays that
 * converge less: sorted by origin alone they make narrow packets, and take half the time; for those that
 * go anywhere, sorting what is nearly in order costs as much as it gains. */
#define RSH_INCOHERENT_EXTENT 0.25f
#define RSH_CONVERGING_EXTENT 0.0625f

/* Of so many sampled ranges of rays, how many may be incoherent before the rays are sorted.
 * Rays in no order cost 5 to 8 times as much; sorting 300 K of them brings 47 ms down to 7 and
 * takes 4. */
#define RSH_INCOHERENT_RAYS(sampled) ((sampled) / 2)

/* Bits of a coordinate in the keys of rays; RSH_RAY_CELL_BITS of them make the cell. */
#define RSH_RAY_BITS 7

/* Places ahead of a ray of a sorted list whose ray is asked for. Building and tracing random rays: 1.2
 * times as quick. A whole tile at once, 256 rays, gains half of that: a core waits for a few dozen cache
 * lines at a time. */
#define RSH_RAYS_AHEAD 32

/* The scene's BVH: bvh/. The unit of costs is the surface of the scene's box divided by the
 * number of leaves. */

/* Triangles in a leaf, and children of a node, on the average: what the cuts below come to. */
#define RSH_MEAN_RANGE 14.0f

/* What a leaf costs besides its surface, which is 3 to 9 units. Between a tenth and two thirds
 * of that surface, the number of leaves that rays open hardly changes. */
#define RSH_LEAF_COST 1.5f

/* The same of a node that is cut out of a row of leaves, and holds as many times the
 * surface. */
#define RSH_RANGE_NODE_COST (RSH_MEAN_RANGE * RSH_LEAF_COST)

/* What a node costs besides its surface where nodes come out of a binary tree. With 0, rays
 * open up to 5 % fewer, of a fifth more nodes. */
#define RSH_TREE_NODE_COST 8.0f

/* Boxes that are cut at a time; cuts far from the end do not depend on what follows. */
#define RSH_WINDOW 192
/* Ranges at the end of those that wait for what follows. */
#define RSH_OPEN_RANGES 2

/* Places in the row, to both sides, where a box looks for its nearest neighbour. 2 do for all
 * scenes but one, whose packets then open half as many boxes again; 8 and 16 gain nothing. */
#define RSH_SEARCH_RADIUS 4

/* Rounds of nearest neighbours; afterwards each box joins the next one. In a row where each box
 * is nearest to the next, a round joins a single pair: without a limit, the tree becomes a
 * chain. RSH_MAX_BVH_DEPTH counts on it. */
#define RSH_NEAREST_ROUNDS 12

/* Leaves ahead of the one that is refitted whose cache lines are asked for. Refitting: 1.2 to
 * 1.3 times as quick. */
#define RSH_AHEAD 3

/* An order is degraded when its boxes have so many times the surface that they had when it was
 * made, in relation to that of their triangles, which turn and grow themselves. Rays meet boxes
 * by their surface; above this, tracing loses more than sorting costs. */
#define RSH_DEGRADED 1.2f

/* Traversal by tiles: traverse/tiles/. Halved and doubled, each of these six changed eight
 * cases by 2 % at most. */

/* A tile packet splits into blocks when at most this many of its blocks meet a box, plus one
 * per recent box that none of them met. */
#define RSH_SPLIT_BLOCKS 2

/* A block splits into single rays when at most this many of its rays meet a box, plus one per
 * recent box that none of them met. */
#define RSH_SPLIT_RAYS 3

/* Triangles of a leaf, among those whose boxes the block meets, that are tested without asking
 * first which rays meet the leaf. */
#define RSH_FEW_TRIANGLES 2

/* Fixed cost of one descent, in leaf visits: per packet, per ray. Where it costs more than all
 * leaves of a small scene, rays that agree on nothing stay together: at 8, they took 2.5 times as
 * long in 330 leaves. */
#define RSH_PACKET_COST 40.0f
#define RSH_RAY_COST 3.0f

/* A block is incoherent, and its rays go alone from the start, when it may visit this share of
 * the scene's leaves: its rays agree on no order of boxes. Diffuse rays: 4.8 times as quick; at
 * a lower share, coherent ones lose up to 1.7 times. */
#define RSH_INCOHERENT_SHARE 0.1f

/* Hits that there is room for from which on a list of them is stored past the caches: 4 MB. Listing a
 * million hits: 1.1 times as quick. */
#define RSH_LARGE_LIST 0x40000u

/* The other engines. */

/* Vectors of rays that a work-item of `brute_force` holds while the triangles pass. */
#define RSH_VECTORS_PER_ITEM 4

/* Triangles that a tile of `paper` gathers before it loads its blocks. */
#define RSH_GATHERED 128

/* Stream reduction: reduce/. */

/* Elements that a work-item of a group takes of a tile. */
#define RSH_PER_ITEM 4u

/* Ranges of elements begin at multiples of this. A cache line of bytes that say what is kept,
 * or of 16-byte elements a multiple of it. */
#define RSH_RANGE_STEP 64u

/* Elements that a single work-item counts and then, still in the nearest cache, packs. */
#define RSH_CACHED_RANGE 2048u

/* Elements that are packed in the nearest cache before they are stored past the caches. */
#define RSH_STAGE 1024u

/* Words of a stream from which on its output is stored past the caches: 32 MB, more than the
 * caches that a core may hope for. */
#ifndef RSH_LARGE_WORDS
#define RSH_LARGE_WORDS 0x800000u
#endif

/* Cache lines, in words, ahead of a store in place that are asked for. Without, each store
 * waits for its line: 5 to 8 % where most is kept. */
#define RSH_STORE_AHEAD 128

/* Times that `lookback` looks at a silent tile before it counts that tile itself. */
#ifndef RSH_PATIENCE
#define RSH_PATIENCE 10000
#endif

#endif
