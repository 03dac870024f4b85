% RUNOUTLENGTH  Run-out of a collapsing column: two power laws and a kink.
%
% CALL: L = runOutLength (ASPECT, FACTOR, CRITICAL)
%
%   ASPECT    1 x m or n x m, height over length of the column
%   FACTOR    n x 1, run-out over length at aspect ratio 1 (about 1.2 to 1.8)
%   CRITICAL  n x 1, aspect ratio of the kink (about 2.3)
%   L         n x m, run-out over length
%
% L = f a up to the critical ratio, f ac (a / ac)^(2/3) above: planar columns,
% Lube et al. 2005, Balmforth and Kerswell 2005; the kink made continuous.
%
% See also: foreignLab

function L = runOutLength (aspect, factor, critical)
  ratio = aspect ./ critical;
  L = factor .* critical .* min (ratio, max (ratio, 0).^(2 / 3));
end

%!test % linear, then 2/3 power, continuous between
%! L = runOutLength ([0, 1, 2, 2.5, 20], 1.4, 2.5);
%! assert (L(1:4), 1.4 * [0, 1, 2, 2.5], 1e-12);
%! assert (L(5) / L(4), 8^(2 / 3), 1e-12);
