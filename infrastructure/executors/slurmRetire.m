% SLURMRETIRE  Removes the batch folders that nobody needs any more.
%
% CALL: FLIGHT = slurmRetire (FLIGHT)
%       FLIGHT = slurmRetire (FLIGHT, B)
%
%   FLIGHT  see slurmAttach; a batch goes when none of its runs is open
%   B       index of a batch that Slurm refused: its runs are given up
%
% See also: slurmDiscard, slurmAttach, slurmVoid

function flight = slurmRetire (flight, b)
  if nargin > 1
    isOurs = flight.batch == b & flight.status == 'o';
    cellfun (@slurmVoid, flight.folder(isOurs));
    slurmDiscard (flight.batches(b).path);
    return
  end
  isHeld = flight.status == 'o' | flight.status == 'e';
  held = unique (flight.batch(isHeld));
  for b = setdiff (unique (flight.batch(flight.batch > 0)), held)
    isGone = flight.batch == b;
    if flight.batches(b).left == sum (isGone)
      slurmDiscard (flight.batches(b).path);
    end
    flight.batch(isGone) = 0;
  end
end

%!test
%! store = tempname ();
%! mkdir (fullfile (store, 'a'));
%! mkdir (fullfile (store, 'b'));
%! f = struct ('status', 'sso', 'batch', [1, 1, 2]);
%! f.batches = struct ('path', {[store, '/a'], [store, '/b']}, 'left', {2, 2});
%! f = slurmRetire (f);
%! assert (f.batch, [0, 0, 2]);
%! assert (readdir (store), {'.'; '..'; 'b'});
%! % one more run of b belongs to nobody here: its folder stays
%! f.status = 'sss';
%! f = slurmRetire (f);
%! assert (readdir (store), {'.'; '..'; 'b'});
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (store, 's');
