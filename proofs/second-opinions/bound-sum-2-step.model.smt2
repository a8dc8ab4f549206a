; A model of the hypotheses of bound-sum-2-step.smt2
; Says: Four edges, three vertices, j = 1.
; Expected: sat

(set-logic ALL)
(define-fun m () Real 4.0)
(define-fun n () Real 3.0)
(define-fun j () Real 1.0)
(define-fun sum () Real 19.0)
(define-fun sum_after () Real 30.0)
(define-fun sum_2 ((j Real)) Real
  (+ (* j n) (* 2.0 (- n 1.0) (- (* 2.0 m) (* 2.0 (- n 1.0))) j) (* (- 2.0) (- n 1.0) j (- j 1.0))))

(assert (= sum (sum_2 j)))
(assert (= sum_after (+ sum n (* 2.0 (- n 1.0) (- (- (* 2.0 m) (* 2.0 (- n 1.0))) (* 2.0 j))))))
(check-sat)
