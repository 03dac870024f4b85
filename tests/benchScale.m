% BENCHSCALE  Variables that make a bench small and short, for tests.
%
% CALL: VARIABLES = benchScale (MODEL)
%
% MODEL      text, name of a bench
% VARIABLES  scalar struct to append to its data.head: some ten to a hundred
%            grains, a few tenths of a second; too short for rest, so that only
%            the grains' places count
%
% See also: benchTrial
function variables = benchScale (model)
  switch model
    case 'Collapse'
      variables = struct ('columnSolid', 0.01, 'restTime', 0.15);
    case 'Drum'
      variables = struct ('drumSolid', 0.06, 'restTime', 0.12, ...
                          'skip1', 0.04, 'skip2', 0.04, 'skip3', 0.04, ...
                          'read1', 0.04, 'read2', 0.04, 'read3', 0.04);
    case 'Heap'
      variables = struct ('heapSolid', 4e-6, 'restTime', 0.12, ...
                          'liftHeight', 0.012);
    case 'Shear'
      variables = struct ('cellSolid', 0.006, 'restTime', 0.12, ...
                          'skipTime', 0.04, 'readTime', 0.04);
    case 'SlotBin'
      variables = struct ('binSolid', 0.006, 'restTime', 0.12);
    otherwise
      error ('DEcalioc:benchScale:unknownName', ...
             'benchScale: MODEL must be a bench with a scale, got %s.', model);
  end
end

%!assert (benchScale ('Heap').heapSolid, 4e-6)
%!error id=DEcalioc:benchScale:unknownName benchScale ('NoBench')
