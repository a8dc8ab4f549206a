; A model of the hypotheses of variant-bounds-passes.smt2
; Says: A world of three edges, two of them explored before the pass.
; Expected: sat

(set-logic ALL)
(define-fun edges_world () Int 3)
(define-fun edges_map () Int 2)
(define-fun edges_map_after () Int 3)
(define-fun t () Int 1)
(define-fun t_after () Int 0)

(assert (= t (- edges_world edges_map)))
(assert (= t_after (- edges_world edges_map_after)))
(assert (= edges_map_after (+ edges_map 1)))
(assert (<= edges_map_after edges_world))
(check-sat)
