; A model of the hypotheses of bound-sum-1-step.smt2
; Says: Three edges, q = 1.
; Expected: sat

(set-logic ALL)
(define-fun m () Real 3.0)
(define-fun q () Real 1.0)
(define-fun sum () Real 1.0)
(define-fun sum_after () Real 11.0)
(define-fun six_sum_1 ((q Real)) Real
  (+ (* 3.0 q (+ q 1.0)) (* 12.0 m q (- q 1.0)) (* (- 4.0) (- q 1.0) q (- (* 2.0 q) 1.0))))

(assert (= (* 6.0 sum) (six_sum_1 q)))
(assert (= sum_after (+ sum (+ q 1.0) (* 2.0 q (- (* 2.0 m) (* 2.0 q))))))
(check-sat)
