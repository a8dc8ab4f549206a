; A model of the hypotheses of bound-run-step.smt2
; Says: The last pass on a triangle.
; Expected: sat

(set-logic ALL)
(define-fun m () Real 3.0)
(define-fun n () Real 3.0)
(define-fun p () Real 2.0)
(define-fun s () Real 3.0)
(define-fun cost () Real 5.0)
(define-fun cost_pass () Real 7.0)
(define-fun cost_after () Real 12.0)
(define-fun sum () Real 11.0)
(define-fun sum_after () Real 22.0)
(define-fun pass_bound ((s Real) (p Real)) Real (+ s (* 2.0 (- s 1.0) (- (* 2.0 m) (* 2.0 p)))))
(define-fun least ((x Real) (y Real)) Real (ite (<= x y) x y))

(assert (< p m))
(assert (<= s (+ p 1.0)))
(assert (<= s n))
(assert (<= cost_pass (pass_bound s p)))
(assert (= cost_after (+ cost cost_pass)))
(assert (= sum_after (+ sum (pass_bound (least (+ p 1.0) n) p))))
(assert (<= cost sum))
(check-sat)
