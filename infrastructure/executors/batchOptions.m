% BATCHOPTIONS  Fills in what the user left out about a queue.
%
% CALL: OPT = batchOptions (GIVEN, WORDS)
%
%   GIVEN  struct Input.<name> as the user wrote it, see batchExecutor; every
%          field may be missing or empty
%   WORDS  1 x n cell, names of the queue's own fields that hold a text
%   OPT    struct with all fields:
%     extra        1 x n cell of further options of the program that submits
%     before       1 x n cell of shell commands that a job carries out first
%     time         time limit of a job (min), NaN = from the model's time limit
%     maxInFlight  runs that are submitted and not ended, at most; 200
%     sets         parameter sets tried at a time after the plan; 8
%     poll         time between two looks at the queue (s); 10
%     grace        how long to wait for the files of a run that the queue says
%                  has ended (s), longer than the attribute cache of a network
%                  file system; 30
%     and those of WORDS, '' = the queue's default

function opt = batchOptions (given, words)
  opt = struct ('extra', {{}}, 'before', {{}}, 'time', NaN, ...
                'maxInFlight', 200, 'sets', 8, 'poll', 10, 'grace', 30);
  for k = 1:numel (words)
    opt.(words{k}) = '';
  end
  if isempty (given)
    return
  end
  for name = fieldnames (given)'
    if ~isempty (given.(name{1}))
      opt.(name{1}) = given.(name{1});
    end
  end
  for name = {'extra', 'before'}
    opt.(name{1}) = cellstr (opt.(name{1}))(:)';
  end
end

%!test
%! o = batchOptions ([], {'partition'});
%! assert (o.partition, '');
%! assert (isempty (o.extra));
%! assert ([o.time, o.maxInFlight, o.sets, o.poll, o.grace], ...
%!         [NaN, 200, 8, 10, 30]);
%!test
%! o = batchOptions (struct ('time', 90, 'extra', {{'--mem=2G'; '--qos=a'}}, ...
%!                           'before', 'module load a', 'poll', []), {});
%! assert (o.extra, {'--mem=2G', '--qos=a'});
%! assert (o.before, {'module load a'});
%! assert ([o.time, o.poll], [90, 10]);
