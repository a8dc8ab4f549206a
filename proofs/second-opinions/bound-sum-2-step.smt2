; Sum (2) in closed form: induction step over its terms
; Says: The first j terms n + 2(n-1)(2m-2(n-1)-2(i-1)), i = 1 .. j, add up to the polynomial
;   sum_2; it is 0 for j = 0. Step: with the term i = j+1.
; Paper: VI, sum (2)
; Symbols:
;   m, n           edges and vertices of the world
;   j               number of terms
;   sum, sum_after  the sum of the first j and j+1 terms
;   sum_2           j n + 2(n-1)(2m-2(n-1)) j - 2(n-1) j(j-1)
; Expected: unsat

(set-logic QF_NRA)
(declare-const m Real)
(declare-const n Real)
(declare-const j Real)
(declare-const sum Real)
(declare-const sum_after Real)
(define-fun sum_2 ((j Real)) Real
  (+ (* j n) (* 2.0 (- n 1.0) (- (* 2.0 m) (* 2.0 (- n 1.0))) j) (* (- 2.0) (- n 1.0) j (- j 1.0))))

; induction hypothesis
(assert (= sum (sum_2 j)))
; the term i = j+1
(assert (= sum_after (+ sum n (* 2.0 (- n 1.0) (- (- (* 2.0 m) (* 2.0 (- n 1.0))) (* 2.0 j))))))

; not: the closed form for j+1, and 0 for no term
(assert (not (and (= sum_after (sum_2 (+ j 1.0))) (= (sum_2 0.0) 0.0))))
(check-sat)
