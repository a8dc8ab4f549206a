; The bound of a pass grows with the number of vertices known
; Says: A pass that finds p edges explored and s vertices known costs at most s + 2(s-1)(2m-2p);
;   more vertices known only raise this, as long as an edge is left. So the worst case has them
;   early.
; Paper: VI, sums (1) and (2) ('A worst case scenario would see ...')
; Symbols:
;   m              edges of the world
;   p              edges explored before the pass
;   s, t           numbers of vertices known
;   pass_bound     s + 2(s-1)(2m-2p)
; Expected: unsat

(set-logic QF_NRA)
(declare-const m Real)
(declare-const p Real)
(declare-const s Real)
(declare-const t Real)
(define-fun pass_bound ((s Real) (p Real)) Real (+ s (* 2.0 (- s 1.0) (- (* 2.0 m) (* 2.0 p)))))

; more vertices known
(assert (<= s t))
; no more edges explored than there are
(assert (<= p m))

; not: a bound at least as large
(assert (not (<= (pass_bound s p) (pass_bound t p))))
(check-sat)
