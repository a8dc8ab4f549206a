; Sum (1) in closed form: induction step over its terms
; Says: The first q terms s + 2(s-1)(2m-2(s-1)), s = 1 .. q, add up to a sixth of the polynomial
;   six_sum_1; it is 0 for q = 0. Step: with the term s = q+1.
; Paper: VI, sum (1)
; Symbols:
;   m               edges of the world
;   q               number of terms
;   sum, sum_after  the sum of the first q and q+1 terms
;   six_sum_1       3q(q+1) + 12m q(q-1) - 4(q-1)q(2q-1)
; Expected: unsat

(set-logic QF_NRA)
(declare-const m Real)
(declare-const q Real)
(declare-const sum Real)
(declare-const sum_after Real)
(define-fun six_sum_1 ((q Real)) Real
  (+ (* 3.0 q (+ q 1.0)) (* 12.0 m q (- q 1.0)) (* (- 4.0) (- q 1.0) q (- (* 2.0 q) 1.0))))

; induction hypothesis
(assert (= (* 6.0 sum) (six_sum_1 q)))
; the term s = q+1
(assert (= sum_after (+ sum (+ q 1.0) (* 2.0 q (- (* 2.0 m) (* 2.0 q))))))

; not: the closed form for q+1, and 0 for no term
(assert (not (and (= (* 6.0 sum_after) (six_sum_1 (+ q 1.0))) (= (six_sum_1 0.0) 0.0))))
(check-sat)
