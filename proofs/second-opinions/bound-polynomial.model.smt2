; A model of the hypotheses of bound-polynomial.smt2
; Says: A triangle: (1) = 11 and (2) = 11.
; Expected: sat

(set-logic ALL)
(define-fun m () Real 3.0)
(define-fun n () Real 3.0)
(define-fun sum_1 () Real 11.0)
(define-fun sum_2_all () Real 11.0)
(define-fun six_sum_1 ((q Real)) Real
  (+ (* 3.0 q (+ q 1.0)) (* 12.0 m q (- q 1.0)) (* (- 4.0) (- q 1.0) q (- (* 2.0 q) 1.0))))
(define-fun sum_2 ((j Real)) Real
  (+ (* j n) (* 2.0 (- n 1.0) (- (* 2.0 m) (* 2.0 (- n 1.0))) j) (* (- 2.0) (- n 1.0) j (- j 1.0))))

(assert (= (* 6.0 sum_1) (six_sum_1 (- n 1.0))))
(assert (= sum_2_all (sum_2 (+ (- m n) 1.0))))
(check-sat)
