% BLINDPLACES  Benches by size and the four targets by z, worst first.
%
% CALL: [BENCHES, TARGETS] = blindPlaces (BENCHNAMES, SIZES, TARGETNAMES, Z)
%
%   BENCHNAMES   1 x b cell;  SIZES  1 x b, discrepancy in standard deviations
%   TARGETNAMES  1 x m cell;  Z      1 x m, residuals in standard deviations
%   BENCHES, TARGETS  text, names with spaces between
%
% See also: blindTable, blindWhere

function [benches, targets] = blindPlaces (benchNames, sizes, targetNames, z)
  [~, order] = sort (-sizes);
  benches = strjoin (benchNames(order), ' ');
  [~, order] = sort (-abs (z));
  targets = strjoin (targetNames(order(1:min (end, 4))), ' ');
end
