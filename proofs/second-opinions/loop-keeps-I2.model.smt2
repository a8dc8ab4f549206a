; A model of the hypotheses of loop-keeps-I2.smt2
; Says: The world is a triangle: v0 with darts a0 a1, v1 with b0 b1, v2 with c0 c1; edges a0b0,
;   a1c0, b1c1. S knows the three vertices, a0b0 and a1c0; e = B1 and h = C1 are the ends of b1c1.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(declare-datatypes ((MapDart 0)) (((A0) (A1) (B0) (B1) (C0) (C1))))
(define-fun alpha ((x Dart)) Dart
  (ite (= x a0) b0 (ite (= x a1) c0 (ite (= x b0) a0 (ite (= x b1) c1 (ite (= x c0) a1 b1))))))
(define-fun seen ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x b1) (= x c0) (= x c1)))
(define-fun known ((x MapDart)) Bool (or (= x A0) (= x A1) (= x B0) (= x B1) (= x C0) (= x C1)))
(define-fun phi ((x MapDart)) Dart
  (ite (= x A0) a0 (ite (= x A1) a1 (ite (= x B0) b0 (ite (= x B1) b1 (ite (= x C0) c0 c1))))))
(define-fun name ((x Dart)) MapDart
  (ite (= x a0) A0 (ite (= x a1) A1 (ite (= x b0) B0 (ite (= x b1) B1 (ite (= x c0) C0 C1))))))
(define-fun walked0 ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x c0)))
(define-fun open0 ((x MapDart)) Bool (or (= x B1) (= x C1)))
(define-fun walked1 ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x b1) (= x c0) (= x c1)))
(define-fun open1 ((x MapDart)) Bool false)
(define-fun e () MapDart B1)
(define-fun h () MapDart C1)

(assert (forall ((x MapDart)) (=> (known x) (and (seen (phi x)) (= (name (phi x)) x)))))
(assert (forall ((d Dart)) (=> (seen d) (and (known (name d)) (= (phi (name d)) d)))))
(assert (forall ((x MapDart)) (=> (open0 x) (and (known x) (not (walked0 (phi x)))))))
(assert (forall ((d Dart)) (=> (and (seen d) (not (walked0 d))) (open0 (name d)))))
(assert (open0 e))
(assert (open0 h))
(assert (= (alpha (phi e)) (phi h)))
(assert (forall ((d Dart))
  (= (walked1 d) (or (walked0 d) (= d (phi e)) (= d (alpha (phi e)))))))
(assert (forall ((x MapDart)) (= (open1 x) (and (open0 x) (not (= x e)) (not (= x h))))))
(check-sat)
