% BLINDPLACES  Benches and the four targets by size, worst first.
%
% CALL: [BENCHES, TARGETS] = blindPlaces (BENCHNAMES, OFBENCHES, TARGETNAMES,
%                                         OFTARGETS)
%
%   BENCHNAMES   1 x b cell;  OFBENCHES  1 x b, size of what is left after the
%                fit, in standard deviations of the noise
%   TARGETNAMES  1 x m cell;  OFTARGETS  1 x m, the same
%   BENCHES, TARGETS  text, names with spaces between
%
% See also: blindTable

function [benches, targets] = blindPlaces (benchNames, ofBenches, ...
                                           targetNames, ofTargets)
  [~, order] = sort (-ofBenches);
  benches = strjoin (benchNames(order), ' ');
  [~, order] = sort (-ofTargets);
  targets = strjoin (targetNames(order(1:min (end, 4))), ' ');
end
