; The sum of the bounds is (1) + (2), term by term
; Says: With s = min(p+1, n): pass p < n-1 has the term n_s = p+1 of (1), and the pass p = n-1 +
;   (i-1) has the term i of (2).
; Paper: VI, sums (1) and (2)
; Symbols:
;   m, n           edges and vertices of the world
;   p              edges explored before the pass
;   s              min(p+1, n)
;   i              number of the term of (2), if p = n-1 + (i-1)
;   term_1, term_2 the terms of (1) and (2) as printed
; Expected: unsat

(set-logic QF_NRA)
(declare-const m Real)
(declare-const n Real)
(declare-const p Real)
(declare-const s Real)
(declare-const i Real)
(define-fun pass_bound ((s Real) (p Real)) Real (+ s (* 2.0 (- s 1.0) (- (* 2.0 m) (* 2.0 p)))))
(define-fun least ((x Real) (y Real)) Real (ite (<= x y) x y))
(define-fun term_1 ((s Real)) Real (+ s (* 2.0 (- s 1.0) (- (* 2.0 m) (* 2.0 (- s 1.0))))))
(define-fun term_2 ((i Real)) Real
  (+ n (* 2.0 (- n 1.0) (- (- (* 2.0 m) (* 2.0 (- n 1.0))) (* 2.0 (- i 1.0))))))

; the most vertices that can be known
(assert (= s (least (+ p 1.0) n)))
; the number of the pass in (2)
(assert (= i (+ (- p (- n 1.0)) 1.0)))

; not: the same terms
(assert (not (and (=> (< p (- n 1.0)) (= (pass_bound s p) (term_1 (+ p 1.0))))
          (=> (<= (- n 1.0) p) (= (pass_bound s p) (term_2 i))))))
(check-sat)
