; (1) + (2) is the polynomial, exactly
; Says: With n-1 terms of (1) and m-n+1 terms of (2): (1) + (2) = 2m^2n - 2mn^2 + 2/3 n^3 - 2m^2 +
;   5mn - 5/2 n^2 - 2m + 11/6 n (times 6 below).
; Paper: VI, expression (3), which leaves out 5mn, -2m and 11/6 n
; Symbols:
;   m, n           edges and vertices of the world
;   sum_1, sum_2_all       (1) and (2)
;   six_sum_1, sum_2       their closed forms (bound-sum-1-step, bound-sum-2-step)
; Expected: unsat

(set-logic QF_NRA)
(declare-const m Real)
(declare-const n Real)
(declare-const sum_1 Real)
(declare-const sum_2_all Real)
(define-fun six_sum_1 ((q Real)) Real
  (+ (* 3.0 q (+ q 1.0)) (* 12.0 m q (- q 1.0)) (* (- 4.0) (- q 1.0) q (- (* 2.0 q) 1.0))))
(define-fun sum_2 ((j Real)) Real
  (+ (* j n) (* 2.0 (- n 1.0) (- (* 2.0 m) (* 2.0 (- n 1.0))) j) (* (- 2.0) (- n 1.0) j (- j 1.0))))

; (1) has n-1 terms
(assert (= (* 6.0 sum_1) (six_sum_1 (- n 1.0))))
; (2) has m-n+1 terms
(assert (= sum_2_all (sum_2 (+ (- m n) 1.0))))

; not: the polynomial
(assert (not (= (* 6.0 (+ sum_1 sum_2_all))
        (+ (* 12.0 m m n) (* (- 12.0) m n n) (* 4.0 n n n) (* (- 12.0) m m) (* 30.0 m n)
           (* (- 15.0) n n) (* (- 12.0) m) (* 11.0 n)))))
(check-sat)
