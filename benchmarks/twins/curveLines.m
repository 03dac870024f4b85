% CURVELINES  Figures of merit of the study on curves with correlated errors.
%
% CALL: LINES = curveLines (S)
%
%   S      of twinsFlags; laboratories 1, 2, 3: neighbours correlated by 0, 0.5,
%          0.9
%   LINES  n x 4 cell: figure, hits, cases (1 x n logical), target (text)
%
% See also: twinsScore, curveTwins, foreignLines

function lines = curveLines (s)
  lines = cell (0, 4);
  rho = [0, 0.5, 0.9];
  for l = unique (s.lab)
    here = s.lab == l;
    strong = here & s.single & s.d >= 3.9;
    name = sprintf ('rho %.1f: ', rho(l));
    part = {'false naming on null', s.named, here & s.null, '<= 0.05'; ...
            'alarm on null', ~s.noGap, here & s.null, '<= 0.05'; ...
            '90 % interval of strength holds it', s.covered, ...
            here & s.single, '0.85 - 0.95'; ...
            'precision of names', s.right, here & s.named, '>= 0.95'; ...
            'top-1, d >= 4', s.top, strong, '>= 0.90'; ...
            'named or grouped rightly, d >= 4', s.right, strong, ''};
    part(:, 1) = strcat ({name}, part(:, 1));
    lines = [lines; part];
  end
end

%!test
%! n = false (1, 2);
%! s = struct ('lab', [1, 3], 'single', [false, true], 'null', ...
%!             [true, false], 'd', [0, 5], 'named', [false, true], ...
%!             'noGap', n, 'covered', [false, true], 'right', n, 'top', n);
%! lines = curveLines (s);
%! assert (size (lines), [12, 4]);
%! assert (lines{9, 1}, 'rho 0.9: 90 % interval of strength holds it');
%! assert (sum (lines{9, 2} & lines{9, 3}), 1);
