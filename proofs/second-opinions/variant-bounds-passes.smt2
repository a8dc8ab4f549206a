; The bound function t is never negative and falls: arithmetic
; Says: t = |E_G| - |E_S|; with one edge more in S, and S no larger than G, 0 <= t' < t.
; Paper: V, step 3
; Symbols:
;   edges_world                  |E_G|
;   edges_map, edges_map_after   |E_S| before and after the pass
;   t, t_after                   the bound function before and after the pass
; Expected: unsat

(set-logic QF_LIA)
(declare-const edges_world Int)
(declare-const edges_map Int)
(declare-const edges_map_after Int)
(declare-const t Int)
(declare-const t_after Int)

; the bound function
(assert (= t (- edges_world edges_map)))
(assert (= t_after (- edges_world edges_map_after)))
; a pass explores one edge (variant-falls)
(assert (= edges_map_after (+ edges_map 1)))
; I-1 after: S is isomorphic to a subgraph of G
(assert (<= edges_map_after edges_world))

; not: t stays non-negative and falls
(assert (not (and (<= 0 t_after) (< t_after t))))
(check-sat)
