; Related darts sense the same: the degree, and with a compass the bearing of the
; reference dart, which is (i, 0) at every vertex i.  sigma^bearing leads there.
;
; The cycle with n vertices has the darts (i, s), 0 <= i < n and s in {0, 1}: at vertex i the
; dart of side 0 leads to vertex i + 1, that of side 1 to vertex i - 1 (modulo n).
; Dart (i, s) of the first cycle and dart (j, t) of the second are related iff s = t.
; The last assertion is the negation of the condition; there must be no model.
(set-logic QF_LIA)
(declare-const n1 Int)
(declare-const n2 Int)
(declare-const i Int)
(declare-const j Int)
(declare-const s Int)
(declare-const t Int)
(define-fun in-cycle ((n Int) (x Int) (a Int)) Bool
  (and (<= 0 x) (< x n) (or (= a 0) (= a 1))))
(define-fun related ((a Int) (b Int)) Bool (= a b))
(define-fun sigma-side ((a Int)) Int (- 1 a))
(define-fun alpha-vertex ((n Int) (x Int) (a Int)) Int
  (ite (= a 0) (ite (= x (- n 1)) 0 (+ x 1)) (ite (= x 0) (- n 1) (- x 1))))
(define-fun alpha-side ((a Int)) Int (- 1 a))
(define-fun degree () Int 2)
(define-fun bearing ((a Int)) Int (ite (= a 0) 0 1))
(assert (and (<= 3 n1) (<= 3 n2)))
(assert (and (in-cycle n1 i s) (in-cycle n2 j t) (related s t)))
(assert (not (and (= degree degree) (= (bearing s) (bearing t))
  (= 0 (ite (= (bearing s) 0) s (sigma-side s))))))
(check-sat)
