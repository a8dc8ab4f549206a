; The run: induction step over the passes
; Says: Before pass p there are p edges explored, so at most p+1 vertices known, and never more
;   than n. The cost so far is at most the sum of the bounds with s = min(p+1, n). Step: with one
;   pass more.
; Paper: VI, sums (1) and (2)
; Symbols:
;   m, n           edges and vertices of the world
;   p, s           edges explored before the pass, vertices known
;   cost, cost_pass, cost_after    traversals before the pass, in it, after it
;   sum, sum_after                 sum of the bounds of the passes before it, and with it
;   pass_bound     s + 2(s-1)(2m-2p)
; Expected: unsat

(set-logic QF_NRA)
(declare-const m Real)
(declare-const n Real)
(declare-const p Real)
(declare-const s Real)
(declare-const cost Real)
(declare-const cost_pass Real)
(declare-const cost_after Real)
(declare-const sum Real)
(declare-const sum_after Real)
(define-fun pass_bound ((s Real) (p Real)) Real (+ s (* 2.0 (- s 1.0) (- (* 2.0 m) (* 2.0 p)))))
(define-fun least ((x Real) (y Real)) Real (ite (<= x y) x y))

; an edge is left
(assert (< p m))
; p edges join at most p+1 vertices, and there are n
(assert (<= s (+ p 1.0)))
(assert (<= s n))
; one pass (bound-one-pass)
(assert (<= cost_pass (pass_bound s p)))
(assert (= cost_after (+ cost cost_pass)))
; the next term
(assert (= sum_after (+ sum (pass_bound (least (+ p 1.0) n) p))))
; induction hypothesis
(assert (<= cost sum))

; not: the same after the pass
(assert (not (<= cost_after sum_after)))
(check-sat)
