% GIVEORDER  Leaves an order for a worker: whole, or not at all.
%
% CALL: giveOrder (PLACE, ORDER)
%
%   PLACE   folder (text), see carryRun
%   ORDER   struct: k (number of the run), job (see newJobs), folder (of the
%           run), hasEnded (logical)
%
% Not by writeAtomic: an order need not outlive a power cut, and a sync would
% take 20 ms a step.
%
% Errors: DEcalioc:giveOrder:cannotWrite

function giveOrder (place, order)
  draft = fullfile (place, 'draft');
  if ~saveWhole ('-binary', draft, order)
    error ('DEcalioc:giveOrder:cannotWrite', ...
           ['giveOrder: %s must hold what was written to it. The disk of ' ...
            'TMPDIR may be full: free some space and start again; finished ' ...
            'runs are kept.'], draft);
  end
  rename (draft, fullfile (place, sprintf ('%d.order', order.k)));
end

%!test
%! place = tempname ();
%! mkdir (place);
%! order = struct ('k', 7, 'job', struct ('params', [1, NaN]), ...
%!                 'folder', 'here', 'hasEnded', false);
%! giveOrder (place, order);
%! assert (isequaln (load (fullfile (place, '7.order')), order));
%! assert (numel (readdir (place)), 3);
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (place, 's');
%!error id=DEcalioc:giveOrder:cannotWrite
%! giveOrder (tempname (), struct ('k', 1));
